#include "scene/build/build_laws.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include <rigid_body_sim/dynamics/central_gravity.hpp>
#include <rigid_body_sim/dynamics/spring.hpp>
#include <rigid_body_sim/dynamics/tether.hpp>
#include <rigid_body_sim/scene/scene_error.hpp>

#include "scene/build/body_names.hpp"
#include "scene/build/build_contacts.hpp"
#include "scene/build/build_medium.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

/// Makes laws of the entry `forces[index]`, one overload per kind of law.
class LawBuilder {
 public:
  LawBuilder(const Scene& scene, const std::vector<Body>& bodies)
      : scene_(scene), bodies_(bodies), frames_(scene, bodies), contacts_(scene, bodies, frames_) {
    for (const Body& body : bodies) names_.insert(body.name);
  }

  ForceLaws build() {
    for (const ForceDef& force : scene_.forces) {
      force_ = &force;
      try {
        std::visit([this](const auto& def) { add(def); }, force.law);
      } catch (const std::invalid_argument& refused) {
        fail(force.line, refused.what());
      }
      ++index_;
    }
    addMediumLaws(scene_, bodies_, laws_);
    return std::move(laws_);
  }

 private:
  void add(const SpringDef& def) {
    const auto [from, to] = endsOf(def.from, def.to);
    laws_.push_back(std::make_shared<Spring>(
        from, to, Spring::Constants{def.stiffness, def.damping, def.rest_length}));
  }

  void add(const TetherDef& def) {
    const auto [from, to] = endsOf(def.from, def.to);
    laws_.push_back(std::make_shared<Tether>(
        from, to, Tether::Constants{def.stiffness, def.damping, def.length}));
  }

  void add(const ContactDef& def) {
    for (const std::shared_ptr<const ForceLaw>& law : contacts_.lawsOf(def)) laws_.push_back(law);
  }

  /// One law per body that moves.
  void add(const CentralGravityDef& def) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      if (!bodies_[i].fixed)
        laws_.push_back(std::make_shared<CentralGravity>(i, def.center, def.mu, def.gradient));
    }
  }

  std::pair<Spring::End, Spring::End> endsOf(const SpringEndDef& def_from,
                                             const SpringEndDef& def_to) const {
    const Spring::End from = endOf(def_from, "from"), to = endOf(def_to, "to");
    if (from.body == to.body)
      fail(force_->line, from.body == kWorld
                             ? "from and to must not both be fixed in the world"
                             : "from and to must not be on one body, '" + def_from.body + "'");
    return {from, to};
  }

  /// An end on a body that never moves is a point of the world.
  Spring::End endOf(const SpringEndDef& def, const std::string& key) const {
    if (def.body.empty()) return {kWorld, def.point};
    if (names_.count(def.body) == 0)
      fail(def.line, key + ".body must be one of " + nameList(namesOf(bodies_)) + ", got '" +
                         printable(def.body) + "'" + didYouMean(def.body, namesOf(bodies_)));
    const FixedFrame& frame = *frames_.find(def.body);
    return {frame.body, frame.X_PF * def.point};
  }

  [[noreturn]] void fail(int line, const std::string& message) const {
    throw SceneError(scene_.source, line, "forces[" + std::to_string(index_) + "]: " + message);
  }

  const Scene& scene_;
  const std::vector<Body>& bodies_;
  const FrameTable frames_;
  ContactBuilder contacts_;
  std::set<std::string> names_;
  const ForceDef* force_ = nullptr;
  std::size_t index_ = 0;
  ForceLaws laws_;
};

}  // namespace

ForceLaws lawsOf(const Scene& scene, const std::vector<Body>& bodies) {
  const bool any_in_medium =
      std::any_of(scene.bodies.begin(), scene.bodies.end(),
                  [](const BodyDef& body) { return body.drag.any() || body.buoyancy; });
  if (scene.forces.empty() && !any_in_medium) return {};
  return LawBuilder(scene, bodies).build();
}

}  // namespace rigid_body_sim
