#pragma once

#include <string>
#include <vector>

#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// Names of the frames of bodies, points and IMUs on tf: PREFIX/<body>, PREFIX/<body>/<point>. The
/// world's frame has no prefix: it is what nodes with different prefixes have in common.
class TfFrames {
 public:
  /// prefix: empty for none.
  explicit TfFrames(const Scene& scene, const std::string& prefix = "")
      : start_(prefix.empty() ? "" : prefix + "/") {
    for (const BodyDef& body : scene.bodies) {
      bodies_.push_back(named(frameOf(body)));
      names_.push_back(named(body.name));
    }
  }

  /// Of neither.
  std::string named(const std::string& name) const { return start_ + name; }

  const std::vector<std::string>& bodies() const { return bodies_; }
  const std::string& of(std::size_t body) const { return bodies_[body]; }
  /// Of a point or an IMU.
  std::string of(std::size_t body, const std::string& part) const {
    return names_[body] + "/" + part;
  }

 private:
  std::string start_;
  std::vector<std::string> bodies_;
  std::vector<std::string> names_;
};

}  // namespace rigid_body_sim
