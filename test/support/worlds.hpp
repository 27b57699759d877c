#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/drag.hpp>
#include <rigid_body_sim/dynamics/medium_drag.hpp>
#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/dynamics/spring.hpp>

#include "support/reference_laws.hpp"

/// Small worlds that the tests share.
namespace rigid_body_sim::test {

/// A body of the given principal moments whose body frame is its principal frame.
Body principalBody(const std::string& name, double mass, const Vector3d& I);

/// A body of 2 kg without symmetry, of about 1 kg m², that turns about a point of its frame B.
Body bodyOnPivot(const std::string& name, const Vector3d& point_B);

struct Bench {
  World world;
  State initial;
  std::vector<reference::Law> reference_laws;  ///< the laws of the world, for the reference

  /// Adds a body with the given motion of its body frame; returns its index.
  std::size_t add(const Body& body, const BodyFrameMotion& motion);

  /// Fixes a body where it starts.
  void fix(std::size_t body);

  void addSpring(const Spring::End& from, const Spring::End& to,
                 const Spring::Constants& constants);
  void addCentralGravity(std::size_t body, const Vector3d& center, double mu, bool gradient);
  void addDrag(std::size_t body, const Drag::Coefficients& coefficients);
  void addMediumDrag(std::size_t body, const MediumDrag::Coefficients& drag, const Vector3d& w_W);
  void addBuoyancy(std::size_t body, double displaced, const Vector3d& centroid_P);

  Simulation simulation(const std::string& integrator, double time_step) const;

  /// The state after `steps` steps that together last `duration`.
  State run(const std::string& integrator, double duration, int steps) const;
};

/// A motion with the given velocities at the world's origin; w_B in body axes.
BodyFrameMotion tumbling(const Vector3d& v_W, const Vector3d& w_B,
                         const Quaterniond& q_WB = Quaterniond::Identity());

/// Box 0.1 × 0.4 × 0.9 m of 10 kg, thrown as in the "complex" case of the OSRF boxes benchmark.
Bench complexBox();

Bench restingBox();

PointWrench worldForce(const Vector3d& force, double start, double end);

/// Box 1 × 0.5 × 0.25 m of 2 kg under gravity, pushed by a wrench of the given axes and place; at
/// full strength it spins the box up to some 60 rad/s in a second.
Bench pushedBox(std::size_t axes, std::size_t point_frame, double strength = 1);

}  // namespace rigid_body_sim::test
