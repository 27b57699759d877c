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

/// The frames of a scene by name: the world frame, `<body>`, the body's tf frame where that is
/// another name, `<body>/<point>`. Those of a body that never moves are frames of the world.
class FrameTable {
 public:
  /// The world frame and those of all bodies. bodies: those of the world built from the scene.
  FrameTable(const Scene& scene, const std::vector<Body>& bodies);

  /// Adds the frames of a body that has none in the table. index: where the body is in the world.
  void add(const BodyDef& def, const Body& body, std::size_t index);

  /// Removes the frames of a body, and those that are attached to them.
  void remove(const std::string& body);

  /// Adds a frame F that moves with G, at pose X_GF. Throws std::invalid_argument where there is no
  /// G.
  void attach(const std::string& name, const std::string& G, const Isometry3d& X_GF);

  /// Gives the frames of a body in its principal frame P, which was another; see MassInput.
  void setPrincipalFrame(std::size_t body, const Isometry3d& X_BP);

  /// Null for an unknown name.
  const FixedFrame* find(const std::string& name) const;

  /// "world, box, box/thruster": in the order of the scene, cut short after the first ten.
  std::string names() const;

  /// "; did you mean 'box'?" for a name that differs little from one of the table; else empty.
  std::string suggestion(const std::string& name) const;

 private:
  struct Entry {
    FixedFrame frame;
    std::string body;  // to which it is fixed, moving or not; empty: the world
    Isometry3d X_BF = Isometry3d::Identity();  // in the body frame, from which X_PF follows
  };
  void put(const std::string& name, const Entry& entry);

  std::map<std::string, Entry> frames_;
  std::vector<std::string> order_;
};

}  // namespace rigid_body_sim
