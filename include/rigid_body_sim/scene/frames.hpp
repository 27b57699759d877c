#pragma once

#include <map>
#include <string>

#include <rigid_body_sim/dynamics/world.hpp>
#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// A frame F that is fixed to a body, or to the world.
struct FixedFrame {
  std::size_t body = kWorld;                 ///< index, or kWorld
  Isometry3d X_PF = Isometry3d::Identity();  ///< in the body's principal frame, or in the world
};

/// The frames of a scene by name: the world frame, `<body>`, `<body>/<point>`. Those of a body that
/// never moves are frames of the world.
class FrameTable {
 public:
  /// bodies: those of the world that was built from the scene.
  FrameTable(const Scene& scene, const std::vector<Body>& bodies);

  /// Adds a frame F at pose X_GF in a frame G of the table, which it moves with.
  void attach(const std::string& name, const std::string& G, const Isometry3d& X_GF);

  /// Null for an unknown name.
  const FixedFrame* find(const std::string& name) const;

  /// "world, box, box/thruster": in the order of the scene, cut short after the first ten.
  std::string names() const;

 private:
  void add(const std::string& name, const FixedFrame& frame);

  std::map<std::string, FixedFrame> frames_;
  std::vector<std::string> order_;
};

}  // namespace rigid_body_sim
