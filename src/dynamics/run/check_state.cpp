#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

#include "dynamics/max_steps.hpp"
#include "dynamics/require.hpp"
#include "dynamics/run/check_input.hpp"
#include "dynamics/state_of_world.hpp"

/// The rules of a state from which a run begins.
namespace rigid_body_sim {
namespace {

/// Of what a motion has changed: far above what another machine's rounding leaves of it (whole runs
/// on Debian 11 and 12 differ by at most 3e-10), far below what is meant as a change.
constexpr double kAgree = 1e-9;
/// The same of large numbers that motions are added to: places, and angles of many turns.
constexpr double kLastDigits = 1e-12;

/// A run has t = n h, rounded: t/h is off by two roundings, of which twice are allowed. A program
/// that adds up steps has less exact times, by this share of a step.
constexpr double kAddedUp = 1e-6, kRounded = 4 * std::numeric_limits<double>::epsilon();

/// A fixed body stays where it is whatever its momenta say, and sensors on it would read them.
void checkStill(const std::string& body, const BodyState& s) {
  checkPose(body, s);
  require(s.p_W.isZero(0) && s.L_W.isZero(0) && s.L_P.isZero(0), "body '", body,
          "' is fixed, its momentum and angular momentum must be zero");
}

/// [N], [rad/s] What a thruster starts from, or a rotor.
double firstValueOf(const Actuator& actuator) {
  const auto* rotor = std::get_if<Rotor>(&actuator.kind);
  return rotor ? rotor->speed : 0;
}

void checkActuatorState(const std::string& who, const Actuator& actuator, const ActuatorState& own,
                        double now) {
  require(std::isfinite(own.command) && std::isfinite(own.value), who,
          "command and value must be finite");
  require(own.since <= now, who, "since must not be later than the state, at t = ", shortest(now),
          " s", Got{own.since});
  require(!std::isnan(own.until), who, "until must be a number");
  require(own.command >= actuator.least && own.command <= actuator.greatest, who,
          "command must be within the limits, ", shortest(actuator.least), " to ",
          shortest(actuator.greatest), Got{own.command});
  if (std::holds_alternative<Wheel>(actuator.kind)) return;  // limits are those of its torque
  // a lag ends at the limit but for its last digits
  const double least = std::min(actuator.least, firstValueOf(actuator)),
               greatest = std::max(actuator.greatest, firstValueOf(actuator)),
               rounding = kLastDigits * std::abs(own.value);
  require(own.value >= least - rounding && own.value <= greatest + rounding, who,
          "value must be within what it can reach, ", shortest(least), " to ", shortest(greatest),
          Got{own.value});
}

void checkActuatorStates(const World& world, const State& state) {
  for (std::size_t i = 0; i < state.actuators.size(); ++i)
    for (std::size_t k = 0; k < state.actuators[i].size(); ++k) {
      const Actuator& actuator = world.bodies[i].actuators[k];
      checkActuatorState("body '" + world.bodies[i].name + "': actuator '" + actuator.name + "': ",
                         actuator, state.actuators[i][k], state.t);
    }
}

void checkSchedules(const World& world, const State& state) {
  if (state.schedules.empty()) return;
  require(state.schedules.size() == world.bodies.size(),
          "a state must have a schedule for each body, or for none");
  const double rounding = kAddedUp * world.solver.time_step + kRounded * state.t;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const auto requireOwn = [&](std::size_t body) {
      require(body == i, "body '", world.bodies[i].name, "': its schedule must be of that body");
    };
    for (const ScheduledWrench& entry : state.schedules[i].wrenches) {
      checkWrench(world, entry.wrench);
      requireOwn(entry.wrench.body);
      require(entry.wrench.end >= std::max(entry.wrench.start, state.t - rounding),
              "wrench on body '", world.bodies[i].name,
              "': end must not be before its start, nor before the state, at t = ",
              shortest(state.t), " s", Got{entry.wrench.end});
    }
    for (const ActuatorCommand& command : state.schedules[i].commands) {
      checkCommand(world, command);
      requireOwn(command.body);
    }
  }
}

void checkLawStates(const World& world, const State& state) {
  const double* own = state.laws.data();
  for (std::size_t law = 0; law < world.laws.size() && !state.laws.empty(); ++law) {
    require(world.laws[law]->stateCount() == 0 || world.laws[law]->admits(own), "law ", law, " (",
            world.laws[law]->name(), "): its states must be those of one of its modes");
    own += world.laws[law]->stateCount();
  }
}

/// One that has come to rest has no momentum: its steps leave it where it is.
void checkResting(const World& world, const State& state, std::size_t body) {
  const BodyState& s = state.bodies[body];
  require(s.p_W.isZero(0) && s.L_P.isZero(0), "body '", world.bodies[body].name,
          "': its momenta must be zero, as its group is at rest");
}

void checkPlan(const World& world, const State& state, const MotionPlan& plan,
               const std::string& who) {
  require(!plan.bodies.empty() && std::is_sorted(plan.bodies.begin(), plan.bodies.end()), who,
          "must name its bodies, in the order of the scene");
  require(plan.substeps >= 1, who, "must have at least one substep");
  require(plan.error >= 0, who, "error must be >= 0", Got{plan.error});
  require(!std::isnan(plan.tried_until), who, "tried_until must be a number");
  for (std::size_t body : plan.bodies) {
    checkBody(world, body);
    if (plan.at_rest) checkResting(world, state, body);
  }
  for (const auto* laws : {&plan.laws, &plan.waiting_laws})
    for (std::size_t law : *laws) {
      require(law < world.laws.size(), who, "no law has the index ", law);
      for (std::size_t body : world.laws[law]->members())
        require(std::binary_search(plan.bodies.begin(), plan.bodies.end(), body), who,
                "must have every body of its laws, lacks '", world.bodies[body].name, "' of law ",
                law);
    }
}

/// Plans form groups: each body that moves must be in one, with laws between its bodies only.
void checkPlans(const World& world, const State& state) {
  std::vector<int> times(world.bodies.size());
  for (std::size_t i = 0; i < state.plans.size(); ++i) {
    checkPlan(world, state, state.plans[i], "group " + std::to_string(i) + ": ");
    for (std::size_t body : state.plans[i].bodies) ++times[body];
  }
  for (std::size_t i = 0; i < world.bodies.size() && !state.plans.empty(); ++i)
    require(times[i] == (moves(world.bodies[i]) ? 1 : 0), "body '", world.bodies[i].name,
            "': it must be in one group, got ", static_cast<std::size_t>(times[i]));
  for (std::size_t law : state.near_laws)
    require(law < world.laws.size(), "no law has the index ", law);
  require(std::adjacent_find(state.near_laws.begin(), state.near_laws.end(),
                             std::greater_equal<>()) == state.near_laws.end(),
          "near_laws must be numbers that ascend");
}

void checkAnchors(const World& world, const State& state) {
  require(state.anchors.empty() || state.anchors.size() == world.bodies.size(),
          "a state must have an anchor for each body, or none");
  for (std::size_t i = 0; i < state.anchors.size(); ++i) {
    if (!moves(world.bodies[i])) continue;
    const MotionAnchor& anchor = state.anchors[i];
    require(anchor.t <= state.t && !std::isnan(anchor.horizon), "body '", world.bodies[i].name,
            "': its anchor must not be of the future");
    checkBodyState(world, i, anchor.state);
  }
}

bool isSame(const BodyState& a, const BodyState& b) {
  return a.x_W == b.x_W && a.x_low_W == b.x_low_W && a.q_WP.coeffs() == b.q_WP.coeffs() &&
         a.p_W == b.p_W && a.L_W == b.L_W && a.L_P == b.L_P;
}

/// Whether steps = t/h are whole steps of a run.
bool isWhole(double steps) {
  return steps >= 0 && steps <= kMaxSteps &&
         std::abs(steps - std::round(steps)) <= std::max(kAddedUp, kRounded * steps);
}

}  // namespace

void checkFollows(const Body& body, const MotionAnchor& anchor, double t, const BodyState& led,
                  const BodyState& given) {
  if (isSame(led, given)) return;
  const BodyState& from = anchor.state;
  const double seconds = t - anchor.t;
  const double p = std::max(given.p_W.norm(), from.p_W.norm());
  const double L = std::max(given.L_W.norm(), from.L_W.norm());
  const double place =
      kAgree * p / body.mass * seconds + kLastDigits * std::max(given.x_W.norm(), from.x_W.norm());
  const double turn =
      kAgree + kLastDigits * angularVelocity(body.inv_I, given.L_P).norm() * seconds;
  const bool follows =
      distanceBetween(led, given) <= place && given.q_WP.angularDistance(led.q_WP) <= turn &&
      (given.p_W - led.p_W).norm() <= kAgree * p && (given.L_W - led.L_W).norm() <= kAgree * L &&
      (given.L_P - led.L_P).norm() <= turn * L;
  require(follows, "body '", body.name,
          "': its state must be where its anchor leads at t = ", shortest(t),
          " s: clear the anchors and plans of a state that is changed");
}

void checkFixed(const World& world, const State& given, const State& start) {
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (!world.bodies[i].fixed) continue;
    const BodyState &a = given.bodies[i], &b = start.bodies[i];
    require(distanceBetween(a, b) <= kLastDigits * b.x_W.norm() &&
                a.q_WP.angularDistance(b.q_WP) <= kAgree,
            "body '", world.bodies[i].name,
            "' is fixed: a state must have it where the run has it");
  }
}

void checkState(const World& world, const State& state) {
  require(isWhole(state.t / world.solver.time_step),
          "time must be a multiple of time_step, from 0 to 2^53 of them", Got{state.t});
  requireStateOf(world, state);
  for (double own : state.laws)
    require(std::isfinite(own), "states of laws must be finite numbers", Got{own});
  require(std::isfinite(state.contact_bound) && state.contact_bound >= 0,
          "the bound on steps in contact must be >= 0", Got{state.contact_bound});
  checkLawStates(world, state);
  checkActuatorStates(world, state);
  checkSchedules(world, state);
  checkAnchors(world, state);
  checkPlans(world, state);
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
    if (moves(world.bodies[i]))
      checkBodyState(world, i, state.bodies[i]);
    else if (world.bodies[i].fixed)
      checkStill(world.bodies[i].name, state.bodies[i]);
}

}  // namespace rigid_body_sim
