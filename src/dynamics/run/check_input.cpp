#include "dynamics/run/check_input.hpp"

#include <cmath>
#include <set>
#include <string>
#include <utility>

#include <rigid_body_sim/dynamics/drag.hpp>

#include "dynamics/run/require.hpp"

namespace rigid_body_sim {
namespace {

bool isPositive(double x) { return x > 0 && std::isfinite(x); }

void checkSolver(const SolverOptions& solver) {
  require(isPositive(solver.time_step), "time_step must be > 0 s", solver.time_step);
  require(isPositive(solver.tolerance), "tolerance must be > 0", solver.tolerance);
  require(isPositive(solver.horizon), "horizon must be > 0 s", solver.horizon);
}

/// Those that go by the velocity or the acceleration of the centre of mass.
void checkLawOnPivot(const ForceLaw& law, const std::string& who) {
  const auto* drag = dynamic_cast<const Drag*>(&law);
  require(!(law.needs() & kContact) && !law.gravityCenter() &&
              !(drag && (drag->coefficients().linear > 0 || drag->coefficients().quadratic > 0)),
          who +
              " is on a pivot, beside which contact and central gravity are not supported, and "
              "linear and quadratic drag as MediumDrag alone");
}

/// What a body has one of at most.
struct TakenPlaces {
  std::set<std::size_t> flow;                            // bodies
  std::set<std::pair<std::size_t, std::string>> medium;  // bodies and kinds of laws
};

void checkLaw(const World& world, const ForceLaw& law, TakenPlaces& taken) {
  const std::string name = std::string("law '") + law.name() + "': ";
  const std::vector<std::size_t> members = law.members();
  require(!members.empty(), name + "it must act on a body");
  for (std::size_t body : members) {
    require(body < world.bodies.size(), name + "no body has the index " + std::to_string(body));
    require(!world.bodies[body].fixed,
            name + "body '" + world.bodies[body].name + "' is fixed, no law can move it");
    if (world.bodies[body].pivoted)
      checkLawOnPivot(law, name + "body '" + world.bodies[body].name + "'");
  }
  const bool is_free = !law.hasFlow() || taken.flow.insert(members.front()).second;
  require(is_free && (!law.isOfMedium() ||
                      taken.medium.insert({members.front(), std::string(law.name())}).second),
          name + "body '" + world.bodies[members.front()].name + "' has one already");
}

void checkActuators(const Body& body) {
  if (body.actuators.empty()) return;
  const std::string who = "body '" + body.name + "': ";
  require(!body.fixed, who + "it is fixed, motors cannot move it");
  const Matrix3d R_BP = body.X_BP.linear();
  Matrix3d I_B = R_BP * body.I.asDiagonal() * R_BP.transpose();
  for (const Actuator& actuator : body.actuators)
    if (const auto* wheel = std::get_if<Wheel>(&actuator.kind))
      I_B += wheel->inertia * wheel->axis_B * wheel->axis_B.transpose();
  const std::string fault = actuatorsFault(body.actuators, I_B);
  require(fault.empty(), who + fault);
}

void checkAttitude(const std::string& body, const Quaterniond& q) {
  const double norm = q.norm();
  require(std::abs(norm - 1) < 1e-6, body + "attitude must be a unit quaternion: norm 1", norm);
}

}  // namespace

void checkIndex(const World& world, std::size_t body) {
  require(body < world.bodies.size(), "no body has the index " + std::to_string(body));
}

void checkBody(const World& world, std::size_t body) {
  checkIndex(world, body);
  require(!world.bodies[body].fixed,
          "body '" + world.bodies[body].name + "' is fixed, nothing can move it");
}

void checkWorld(const World& world) {
  checkSolver(world.solver);
  require(world.g_W.allFinite(), "gravity must be finite");
  for (const Body& body : world.bodies)
    require(body.fixed || (isPositive(body.mass) && (body.I.array() > 0).all() &&
                           body.I.allFinite() && body.inv_I.allFinite()),
            "body '" + body.name + "': mass and principal moments must be > 0 and finite");
  TakenPlaces taken;
  for (const auto& law : world.laws) checkLaw(world, *law, taken);
  for (const PointWrench& wrench : world.wrenches) checkWrench(world, wrench);
  for (const Body& body : world.bodies) checkActuators(body);
  for (const ActuatorCommand& command : world.commands) checkCommand(world, command);
  for (const Imu& imu : world.imus) {
    checkIndex(world, imu.body);
    const std::string fault = imuFault(imu);
    require(fault.empty(), "body '" + world.bodies[imu.body].name + "': " + fault);
  }
}

void checkBodyState(const World& world, std::size_t index, const BodyState& s) {
  checkBody(world, index);
  const std::string body = "body '" + world.bodies[index].name + "': ";
  require(s.x_W.allFinite() && s.x_low_W.allFinite(), body + "position must be finite");
  require(s.p_W.allFinite() && s.L_W.allFinite() && s.L_P.allFinite(),
          body + "momenta must be finite");
  require(!world.bodies[index].pivoted || s.p_W.isZero(0),
          body + "p_W must be zero, for it is on a pivot and its state is its rotation alone");
  checkAttitude(body, s.q_WP);
}

void checkCommand(const World& world, const ActuatorCommand& command) {
  // what breaks no rule makes no text: commands come often
  const bool has_actuator = command.body < world.bodies.size() &&
                            !world.bodies[command.body].fixed &&
                            command.actuator < world.bodies[command.body].actuators.size();
  if (has_actuator && std::isfinite(command.value) && std::isfinite(command.start) &&
      command.end > command.start)
    return;
  checkBody(world, command.body);
  const Body& body = world.bodies[command.body];
  require(
      command.actuator < body.actuators.size(),
      "body '" + body.name + "': no actuator has the index " + std::to_string(command.actuator));
  const std::string who =
      "command to '" + body.actuators[command.actuator].name + "' of body '" + body.name + "': ";
  require(std::isfinite(command.value), who + "value must be finite", command.value);
  require(std::isfinite(command.start), who + "start must be finite", command.start);
  require(command.end > command.start, who + "end must be later than its start", command.end);
}

void checkWrench(const World& world, const PointWrench& wrench) {
  checkBody(world, wrench.body);
  const std::string body = "wrench on body '" + world.bodies[wrench.body].name + "': ";
  for (std::size_t frame : {wrench.axes, wrench.point_frame})
    require(frame == kWorld || frame == kOwnBody || frame < world.bodies.size(),
            body + "no body has the index " + std::to_string(frame));
  for (std::size_t frame : {wrench.axes, wrench.point_frame})
    require(frame >= kOwnBody || !world.bodies[frame].fixed,
            body + "axes and point of a fixed body must be given in the world");
  require(wrench.force.allFinite() && wrench.torque.allFinite() && wrench.point.allFinite(),
          body + "force, torque and point must be finite");
  require(!std::isnan(wrench.start) && !std::isnan(wrench.end),
          body + "start and end must be numbers");
}

}  // namespace rigid_body_sim
