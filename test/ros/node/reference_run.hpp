#pragma once

#include <string>

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

class Simulation;

/// Pose of a body frame in the world, and its twist in body axes at its origin.
struct Motion {
  Vector3d position;
  Quaterniond attitude;
  Vector3d linear_B;
  Vector3d angular_B;
};

/// Largest difference of any component; attitudes by the rotation [rad] between them.
double distance(const Motion& a, const Motion& b);

/// The same scene run by the core alone, step for step beside the node. Wrenches are given to the
/// core in its own terms, worked out here and not by the code under test.
class ReferenceRun {
 public:
  explicit ReferenceRun(const std::string& scene_path);
  ReferenceRun(const ReferenceRun& other);
  ReferenceRun& operator=(const ReferenceRun& other);
  ~ReferenceRun();

  void step();
  void reset();
  /// Ends every wrench on a body.
  void clear(const std::string& body);
  double time() const;
  Motion motion(const std::string& body) const;

  /// What acts from `start` [s] for `duration` [s].
  struct Span {
    double start;
    double duration;
  };

  /// World axes, at the centre of mass.
  void pushAtCenterOfMass(const std::string& slot, const std::string& body, const Vector3d& f_W,
                          const Vector3d& tau_W, Span span);

  /// World axes, at a point of the body frame.
  void pushAtPoint(const std::string& slot, const std::string& body, const Vector3d& f_W,
                   const Vector3d& tau_W, const Vector3d& point_B, Span span);

  /// Axes of a frame F that turns with the body, at its origin.
  void pushAtFrame(const std::string& slot, const std::string& body, const Vector3d& f_F,
                   const Vector3d& tau_F, const Isometry3d& X_BF, Span span);

 private:
  std::size_t index(const std::string& body) const;

  Simulation* simulation_;
};

}  // namespace rigid_body_sim
