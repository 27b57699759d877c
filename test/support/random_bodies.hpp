#pragma once

#include <random>

#include <rigid_body_sim/dynamics/body.hpp>
#include <rigid_body_sim/dynamics/state.hpp>

namespace rigid_body_sim {

/// Bodies, states and vectors drawn from a fixed seed.
class Draw {
 public:
  explicit Draw(unsigned seed) : generator_(seed) {}

  double uniform(double low, double high);

  Vector3d vector(double size);

  Quaterniond attitude();

  /// A homogeneous box whose edges span up to the given number of decades: rods, plates and all
  /// between. Its principal frame is its body frame up to the order of the axes.
  Body box(double decades);

  /// Turning at |w| [rad/s] about a random axis, moving at up to 1 m/s within 1 m.
  BodyState state(const Body& body, double w);

 private:
  std::mt19937 generator_;
};

}  // namespace rigid_body_sim
