#include "ros/inputs/mass_service.hpp"

#include <array>

#include "ros/messages/body_index.hpp"
#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {
namespace {

double energyOf(const Simulation& simulation) {
  return mechanicalEnergy(simulation.world(), simulation.state());
}

}  // namespace

geometry_msgs::Inertia toInertia(const MassProperties& properties_B) {
  const Matrix3d& I = properties_B.I_Bcm;
  geometry_msgs::Inertia message;
  message.m = properties_B.mass;
  message.com = toVector3(properties_B.com_B);
  message.ixx = I(0, 0);
  message.iyy = I(1, 1);
  message.izz = I(2, 2);
  message.ixy = I(0, 1);
  message.ixz = I(0, 2);
  message.iyz = I(1, 2);
  return message;
}

MassInput takeMassProperties(const SetMassProperties::Request& request, const World& world) {
  const geometry_msgs::Inertia& given = request.inertia;
  MassInput input;
  input.body = bodyNamed(request.body, world.bodies);
  input.properties_B.mass = given.m;
  input.properties_B.com_B = fromVector3(given.com);
  input.properties_B.I_Bcm << given.ixx, given.ixy, given.ixz, given.ixy, given.iyy, given.iyz,
      given.ixz, given.iyz, given.izz;
  return input;
}

MassService::MassService(ros::NodeHandle private_nh, const InputContext& context)
    : context_(context),
      server_(private_nh.advertiseService("set_mass_properties", &MassService::set, this)) {}

bool MassService::set(SetMassProperties::Request& request, SetMassProperties::Response& response) {
  const Simulation& simulation = context_.simulation;
  double before = 0;
  response.message = context_.apply("set_mass_properties", [&](double) {
    const MassInput input = takeMassProperties(request, simulation.world());
    before = energyOf(simulation);
    return std::array{input};
  });
  response.success = response.message.empty();
  if (response.success) response.energy_change = energyOf(simulation) - before;
  return true;
}

}  // namespace rigid_body_sim
