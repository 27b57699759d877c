#pragma once

#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <rigid_body_sim/dynamics/contact.hpp>
#include <rigid_body_sim/scene/frames.hpp>
#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// Makes the laws of the contact entries of a scene, one for each pair of bodies.
class ContactBuilder {
 public:
  /// Scene, bodies and frames, those of one world, are referred to, not copied.
  ContactBuilder(const Scene& scene, const std::vector<Body>& bodies, const FrameTable& frames);

  /// The laws of an entry of the scene. [body, all] leaves out bodies without a shape, pairs that
  /// do not move, and pairs that another entry names or that an earlier `all` has made. Throws
  /// std::invalid_argument with the rule for bodies that are unknown or cannot touch.
  ForceLaws lawsOf(const ContactDef& def);

 private:
  using Pair = std::pair<std::size_t, std::size_t>;  // the lower index first

  std::size_t indexOf(const std::string& name) const;
  bool claim(const Pair& pair);
  void addWithAll(std::size_t body, const ContactParameters& parameters, ForceLaws& laws);
  std::shared_ptr<const ForceLaw> lawBetween(std::size_t a, std::size_t b,
                                             const ContactParameters& parameters);
  std::shared_ptr<const ForceLaw> lawOnPlane(std::size_t body, std::size_t plane,
                                             const ContactParameters& parameters);
  void requireNoPivot(std::size_t body, const std::string& else_do) const;
  bool isPlane(std::size_t body) const;
  bool touches(std::size_t body) { return isPlane(body) || !shapeOf(body).empty(); }
  const ContactShape& shapeOf(std::size_t body);

  const Scene& scene_;
  const std::vector<Body>& bodies_;
  const FrameTable& frames_;
  std::unordered_map<std::string, std::size_t> index_;
  std::set<Pair> named_;                             // pairs that entries name
  std::set<Pair> made_;                              // pairs that have their law
  std::set<std::size_t> with_all_;                   // bodies of entries [body, all]
  std::vector<std::optional<ContactShape>> shapes_;  // by body, as they are needed
};

}  // namespace rigid_body_sim
