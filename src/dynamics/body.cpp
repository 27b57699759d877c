#include <stdexcept>
#include <utility>

#include <rigid_body_sim/dynamics/body.hpp>
#include <rigid_body_sim/mass/principal_axes.hpp>

#include "dynamics/actuators/lag.hpp"

namespace rigid_body_sim {
namespace {

std::string faultOf(const MassProperties& properties, const Vector3d& origin_B,
                    const Matrix3d& inertia_B, const std::vector<Actuator>& actuators) {
  std::string fault = massPropertiesFault(properties);
  if (fault.empty() && !(origin_B.allFinite() && inertia_B.allFinite()))
    fault = "pivot must be finite, and the inertia about it, too";
  if (fault.empty()) fault = actuatorsFault(actuators, inertia_B);
  return fault;
}

}  // namespace

Body makeBody(std::string name, const MassProperties& properties_B, std::vector<Actuator> actuators,
              const std::optional<Vector3d>& pivot_B) {
  const Vector3d origin_B = pivot_B.value_or(properties_B.com_B);
  const Vector3d arm_B = properties_B.com_B - origin_B;
  const Matrix3d inertia_B =
      pivot_B ? parallelAxes(properties_B.I_Bcm, properties_B.mass, arm_B) : properties_B.I_Bcm;
  const std::string fault = faultOf(properties_B, origin_B, inertia_B, actuators);
  if (!fault.empty()) throw std::invalid_argument("body '" + name + "': " + fault);
  const PrincipalAxes axes = principalAxes(withoutWheels(actuators, inertia_B));
  Body body;
  body.name = std::move(name);
  body.mass = properties_B.mass;
  body.I = axes.I;
  body.inv_I = axes.I.cwiseInverse();
  body.X_BP.setIdentity();
  body.X_BP.linear() = axes.R_BP;
  body.X_BP.translation() = origin_B;
  body.q_BP = Quaterniond(axes.R_BP).normalized();
  body.split = rotationSplit(body.inv_I);
  body.actuators = std::move(actuators);
  body.pivoted = pivot_B.has_value();
  body.com_P = axes.R_BP.transpose() * arm_B;
  return body;
}

Isometry3d frameBefore(const Body& before, const Body& after) {
  if (before.X_BP.matrix() == after.X_BP.matrix()) return Isometry3d::Identity();  // exactly
  return after.X_BP.inverse() * before.X_BP;
}

}  // namespace rigid_body_sim
