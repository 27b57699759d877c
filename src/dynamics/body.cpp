#include <stdexcept>
#include <utility>

#include <rigid_body_sim/dynamics/body.hpp>
#include <rigid_body_sim/mass/principal_axes.hpp>

#include "dynamics/actuators/lag.hpp"

namespace rigid_body_sim {

Body makeBody(std::string name, const MassProperties& properties_B,
              std::vector<Actuator> actuators) {
  std::string fault = massPropertiesFault(properties_B);
  if (fault.empty()) fault = actuatorsFault(actuators, properties_B.I_Bcm);
  if (!fault.empty()) throw std::invalid_argument("body '" + name + "': " + fault);
  const PrincipalAxes axes = principalAxes(withoutWheels(actuators, properties_B.I_Bcm));
  Body body;
  body.name = std::move(name);
  body.mass = properties_B.mass;
  body.I = axes.I;
  body.inv_I = axes.I.cwiseInverse();
  body.X_BP.setIdentity();
  body.X_BP.linear() = axes.R_BP;
  body.X_BP.translation() = properties_B.com_B;
  body.q_BP = Quaterniond(axes.R_BP).normalized();
  body.split = rotationSplit(body.inv_I);
  body.actuators = std::move(actuators);
  return body;
}

}  // namespace rigid_body_sim
