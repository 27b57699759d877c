#include "dynamics/run/check_input.hpp"

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>

#include <rigid_body_sim/dynamics/drag.hpp>

#include "dynamics/require.hpp"
#include "dynamics/wrenches/wrench_size.hpp"

namespace rigid_body_sim {
namespace {

bool isPositive(double x) { return x > 0 && std::isfinite(x); }

void checkSolver(const SolverOptions& solver) {
  require(isPositive(solver.time_step), "time_step must be > 0 s", Got{solver.time_step});
  require(isPositive(solver.tolerance), "tolerance must be > 0", Got{solver.tolerance});
  require(isPositive(solver.horizon), "horizon must be > 0 s", Got{solver.horizon});
  require(solver.threads >= 1 && solver.threads <= SolverOptions::kMaxThreads,
          "threads must be 1 to 1024", Got{static_cast<double>(solver.threads)});
}

/// Those that go by the velocity or the acceleration of the centre of mass.
void checkLawOnPivot(const ForceLaw& law, const std::string& body) {
  const auto* drag = dynamic_cast<const Drag*>(&law);
  require(!(law.needs() & kContact) && !law.gravityCenter() &&
              !(drag && (drag->coefficients().linear > 0 || drag->coefficients().quadratic > 0)),
          "law '", law.name(), "': body '", body,
          "' is on a pivot, beside which contact and central gravity are not supported, and linear "
          "and quadratic drag as MediumDrag alone");
}

/// What a body has one of at most.
struct TakenPlaces {
  std::set<std::size_t> flow;                            // bodies
  std::set<std::pair<std::size_t, std::string>> medium;  // bodies and kinds of laws
};

void checkLaw(const World& world, const ForceLaw& law, TakenPlaces& taken) {
  const std::vector<std::size_t> members = law.members();
  require(!members.empty(), "law '", law.name(), "': it must act on a body");
  require(law.needs() != 0, "law '", law.name(),
          "': it must need something of an integrator, "
          "kCoupling at least, or a body under it would be solved without it");
  for (std::size_t body : members) {
    require(body < world.bodies.size(), "law '", law.name(), "': no body has the index ", body);
    require(!world.bodies[body].fixed, "law '", law.name(), "': body '", world.bodies[body].name,
            "' is fixed, no law can move it");
    if (world.bodies[body].pivoted) checkLawOnPivot(law, world.bodies[body].name);
  }
  const bool is_free = !law.hasFlow() || taken.flow.insert(members.front()).second;
  require(is_free && (!law.isOfMedium() ||
                      taken.medium.insert({members.front(), std::string(law.name())}).second),
          "law '", law.name(), "': body '", world.bodies[members.front()].name,
          "' has one already");
}

void checkActuators(const Body& body) {
  if (body.actuators.empty()) return;
  require(!body.fixed, "body '", body.name, "': it is fixed, motors cannot move it");
  const Matrix3d R_BP = body.X_BP.linear();
  Matrix3d I_B = R_BP * body.I.asDiagonal() * R_BP.transpose();
  for (const Actuator& actuator : body.actuators)
    if (const auto* wheel = std::get_if<Wheel>(&actuator.kind))
      I_B += wheel->inertia * wheel->axis_B * wheel->axis_B.transpose();
  const std::string fault = actuatorsFault(body.actuators, I_B);
  require(fault.empty(), "body '", body.name, "': ", fault);
}

}  // namespace

void checkIndex(const World& world, std::size_t body) {
  require(body < world.bodies.size(), "no body has the index ", body);
}

void checkTimeWithinStep(const World& world, double now, double t) {
  const double h = world.solver.time_step;
  const double rounding = 1e-6 * h + 4 * std::numeric_limits<double>::epsilon() * now;
  require(t >= now - rounding && t <= now + h + rounding,
          "a time must be between now and the next step, from ", shortest(now), " to ",
          shortest(now + h), " s", Got{t});
}

void checkBody(const World& world, std::size_t body) {
  checkIndex(world, body);
  require(!world.bodies[body].fixed, "body '", world.bodies[body].name,
          "' is fixed, nothing can move it");
  require(!world.bodies[body].absent, "body '", world.bodies[body].name,
          "' is absent, nothing acts on it until it comes in");
}

void checkWorld(const World& world) {
  checkSolver(world.solver);
  require(world.g_W.allFinite(), "gravity must be finite");
  for (const Body& body : world.bodies)
    require(body.fixed || (isPositive(body.mass) && (body.I.array() > 0).all() &&
                           body.I.allFinite() && body.inv_I.allFinite()),
            "body '", body.name, "': mass and principal moments must be > 0 and finite");
  for (const GravityCenter& center : world.gravity_centers)
    require(center.center_W.allFinite() && isPositive(center.mu),
            "a center of gravity must be at a finite place, with mu > 0 m^3/s^2", Got{center.mu});
  TakenPlaces taken;
  for (const auto& law : world.laws) {
    require(law != nullptr, "a law must not be null");
    checkLaw(world, *law, taken);
  }
  for (const PointWrench& wrench : world.wrenches) checkWrench(world, wrench);
  for (const Body& body : world.bodies) checkActuators(body);
  for (const ActuatorCommand& command : world.commands) checkCommand(world, command);
  for (const Imu& imu : world.imus) {
    checkIndex(world, imu.body);
    const std::string fault = imuFault(imu);
    require(fault.empty(), "body '", world.bodies[imu.body].name, "': ", fault);
  }
}

void requireFiniteEnergy(const Body& body, const BodyState& state) {
  require(std::isfinite(kineticEnergy(body, state)), "body '", body.name,
          "': its kinetic energy must be a finite number; its velocities are too great");
}

void checkPose(const std::string& body, const BodyState& s) {
  require(s.x_W.allFinite() && s.x_low_W.allFinite(), "body '", body, "': position must be finite");
  const double norm = s.q_WP.norm();
  require(std::abs(norm - 1) < 1e-6, "body '", body,
          "': attitude must be a unit quaternion: norm 1", Got{norm});
}

void checkBodyState(const World& world, std::size_t index, const BodyState& s) {
  checkBody(world, index);
  const std::string& body = world.bodies[index].name;
  checkPose(body, s);
  require(s.p_W.allFinite() && s.L_W.allFinite() && s.L_P.allFinite(), "body '", body,
          "': momenta must be finite");
  require(!world.bodies[index].pivoted || s.p_W.isZero(0), "body '", body,
          "': its momentum must be zero, for it is on a pivot and its state is its rotation alone");
}

void checkCommand(const World& world, const ActuatorCommand& command) {
  checkBody(world, command.body);
  const Body& body = world.bodies[command.body];
  require(command.actuator < body.actuators.size(), "body '", body.name,
          "': no actuator has the index ", command.actuator);
  const std::string& name = body.actuators[command.actuator].name;
  require(std::isfinite(command.value), "command to '", name, "' of body '", body.name,
          "': value must be finite", Got{command.value});
  require(std::isfinite(command.start), "command to '", name, "' of body '", body.name,
          "': start must be finite", Got{command.start});
  require(command.end > command.start, "command to '", name, "' of body '", body.name,
          "': end must be later than its start", Got{command.end});
}

void checkWrench(const World& world, const PointWrench& wrench) {
  checkBody(world, wrench.body);
  const std::string& body = world.bodies[wrench.body].name;
  for (std::size_t frame : {wrench.axes, wrench.point_frame})
    require(frame == kWorld || frame == kOwnBody || frame < world.bodies.size(), "wrench on body '",
            body, "': no body has the index ", frame);
  for (std::size_t frame : {wrench.axes, wrench.point_frame})
    require(frame >= kOwnBody || !world.bodies[frame].fixed, "wrench on body '", body,
            "': axes and point of a fixed body must be given in the world");
  for (std::size_t frame : {wrench.axes, wrench.point_frame})
    require(frame >= kOwnBody || !world.bodies[frame].absent, "wrench on body '", body,
            "': axes and point must not be those of a body that is absent");
  require(wrench.force.allFinite() && wrench.torque.allFinite() && wrench.point.allFinite(),
          "wrench on body '", body, "': force, torque and point must be finite");
  const std::string too_large = wrenchSizeFault(wrench);
  require(too_large.empty(), "wrench on body '", body, "': ", too_large);
  const bool own = wrench.point_frame == kOwnBody || wrench.point_frame == wrench.body;
  require(!wrench.at_center || (own && wrench.point == world.bodies[wrench.body].com_P),
          "wrench on body '", body, "': at its centre of mass, point must be that of the body");
  // one that has been due for ever would be put off with all of that duration
  require(std::isfinite(wrench.start) && !std::isnan(wrench.end), "wrench on body '", body,
          "': start must be finite, end a number");
}

}  // namespace rigid_body_sim
