#include <sstream>
#include <stdexcept>

#include <rigid_body_sim/dynamics/wrench_in_frames.hpp>

namespace rigid_body_sim {
namespace {

void requireMoving(const std::vector<Body>& bodies, std::size_t body) {
  if (body >= bodies.size())
    throw std::invalid_argument("a wrench needs a body: index must be below " +
                                std::to_string(bodies.size()) + ", got " + std::to_string(body));
  if (bodies[body].fixed)
    throw std::invalid_argument("body '" + bodies[body].name + "' is fixed, no wrench can move it");
}

void requireFinite(const Body& body, const char* name, const Vector3d& v) {
  if (v.allFinite()) return;
  std::ostringstream fault;
  fault << "wrench on body '" << body.name << "': " << name << " must be finite, got [" << v.x()
        << ", " << v.y() << ", " << v.z() << "]";
  throw std::invalid_argument(fault.str());
}

/// Axes of force and torque are those of the world.
PointWrench checkedWrench(const std::vector<Body>& bodies, std::size_t body, const Vector3d& force,
                          const Vector3d& torque, const Vector3d& point_B) {
  requireMoving(bodies, body);
  requireFinite(bodies[body], "force", force);
  requireFinite(bodies[body], "torque", torque);
  requireFinite(bodies[body], "point", point_B);
  PointWrench wrench;
  wrench.body = body;
  wrench.force = force;
  wrench.torque = torque;
  wrench.point_frame = body;
  wrench.point = bodies[body].X_BP.inverse() * point_B;
  return wrench;
}

}  // namespace

PointWrench wrenchInBodyAxes(const std::vector<Body>& bodies, std::size_t body,
                             const Vector3d& force_B, const Vector3d& torque_B,
                             const Vector3d& point_B) {
  PointWrench wrench = checkedWrench(bodies, body, force_B, torque_B, point_B);
  const Matrix3d R_PB = bodies[body].X_BP.linear().transpose();
  wrench.axes = body;
  wrench.force = R_PB * force_B;
  wrench.torque = R_PB * torque_B;
  return wrench;
}

PointWrench wrenchInWorldAxes(const std::vector<Body>& bodies, std::size_t body,
                              const Vector3d& force_W, const Vector3d& torque_W,
                              const Vector3d& point_B) {
  return checkedWrench(bodies, body, force_W, torque_W, point_B);
}

PointWrench wrenchAtCenterOfMass(const std::vector<Body>& bodies, std::size_t body,
                                 const Vector3d& force_W, const Vector3d& torque_W) {
  PointWrench wrench = checkedWrench(bodies, body, force_W, torque_W, Vector3d::Zero());
  wrench.point = bodies[body].com_P;
  wrench.at_center = true;
  return wrench;
}

}  // namespace rigid_body_sim
