#include "dynamics/run/solved_motion.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <rigid_body_sim/math/rotation.hpp>

namespace rigid_body_sim {
namespace {

// Numbers from 1/kModest to kModest, over times up to kModestTime, stay finite in every product of
// a solution: (L/I)² is the greatest of them, 1e240.
constexpr double kModest = 1e60;
constexpr double kModestTime = 1e30;

bool isModest(const Vector3d& v) { return v.lpNorm<1>() < kModest; }

bool isModest(const Body& body) {
  return body.mass > 1 / kModest && body.mass < kModest && body.I(0) > 1 / kModest;
}

bool isModest(const BodyState& state) {
  return isModest(state.x_W) && isModest(state.p_W) && isModest(state.L_W);
}

bool isModest(const MediumLoad& load) {
  const double linear = load.linear + load.linear_P.cwiseAbs().sum();
  return linear < kModest && load.quadratic < kModest &&
         load.angular_P.cwiseAbs().sum() < kModest && isModest(load.quadratic_axes) &&
         isModest(load.velocity_W) && isModest(load.center_P) && isModest(load.lift_W) &&
         isModest(load.lift_arm_P);
}

bool isModest(const HeldWrench& wrench) {
  const auto isModestOnBody = [](const HeldWrench::BodyPointForce& applied) {
    return isModest(applied.arm_P) && isModest(applied.force_W);
  };
  const auto isModestInWorld = [](const HeldWrench::WorldPointForce& applied) {
    return isModest(applied.point_W) && isModest(applied.force_W);
  };
  const auto isModestDrive = [](const ActuatorDrive& drive) {
    return drive.forceBound() < kModest && drive.torqueBound() < kModest && isModest(drive.H_0);
  };
  return (!wrench.drive || isModestDrive(*wrench.drive)) &&
         (!wrench.medium || isModest(*wrench.medium)) && isModest(wrench.f_W) &&
         isModest(wrench.tau_W) && isModest(wrench.f_P) && isModest(wrench.tau_P) &&
         std::all_of(wrench.body_point_forces.begin(), wrench.body_point_forces.end(),
                     isModestOnBody) &&
         std::all_of(wrench.world_point_forces.begin(), wrench.world_point_forces.end(),
                     isModestInWorld);
}

}  // namespace

SolvedMotion::Motion SolvedMotion::solve(const SolvedProblem& p, double t, const BodyState& state,
                                         double duration) {
  if (p.wrench.torqueFree())
    return FreeFlight(p.body, p.wrench.f_W + p.body.mass * p.g_W, state, p.read_once);
  if (const auto axial = AxialFlight::of(p.body, p.wrench, p.g_W, state)) return *axial;
  if (p.wrench.drive)
    return Driven(std::in_place, p.body, p.wrench, p.g_W, state, t - p.wrench.drive->start,
                  p.bound);
  if (p.wrench.medium) return InMedium(std::in_place, p.body, p.wrench, p.g_W, state, p.bound);
  return Series(std::in_place, p.body, p.wrench, p.g_W, state, duration, p.bound);
}

SolvedMotion::SolvedMotion(const SolvedProblem& problem, double t, const BodyState& state,
                           double horizon)
    : anchor_(t),
      modest_(isModest(problem.body) && isModest(problem.wrench) && isModest(problem.g_W)),
      motion_(solve(problem, t, state, horizon - t)) {
  if (const auto* series = std::get_if<Series>(&motion_)) {
    valid_until_ = t + (*series)->validFor();
    return;
  }
  if (const auto* driven = std::get_if<Driven>(&motion_)) {
    valid_until_ = t + (*driven)->validFor();
    return;
  }
  if (const auto* in_medium = std::get_if<InMedium>(&motion_)) {
    valid_until_ = t + (*in_medium)->validFor();
    return;
  }
  // [rad] the angle is reduced in 64 bits, 5e-20 of it: beyond, 1e-4 rad are lost
  constexpr double kMaxTurn = 1e15;
  if (const auto* axial = std::get_if<AxialFlight>(&motion_)) {
    valid_until_ = t + axial->timeToTurn(kMaxTurn);
    return;
  }
  valid_until_ = t + kMaxTurn / stableNorm(angularVelocity(problem.body.inv_I, state.L_P));
}

void SolvedMotion::anchorAnew(const SolvedProblem& same_problem, double t, const BodyState& state,
                              double horizon) {
  auto* series = std::get_if<Series>(&motion_);
  // a run that goes on from a saved state takes the closed form where there is one, too
  if (!series || AxialFlight::of(same_problem.body, same_problem.wrench, same_problem.g_W, state)) {
    if (anchorDriven(same_problem, t, state) || anchorInMedium(same_problem, t, state)) return;
    *this = SolvedMotion(same_problem, t, state, horizon);
    return;
  }
  (*series)->startAnew(same_problem.wrench, state, horizon - t);
  anchor_ = t;
  valid_until_ = t + (*series)->validFor();
}

bool SolvedMotion::anchorDriven(const SolvedProblem& same_problem, double t,
                                const BodyState& state) {
  auto* driven = std::get_if<Driven>(&motion_);
  if (!driven) return false;
  (*driven)->startAnew(same_problem.wrench, state, t - same_problem.wrench.drive->start);
  anchor_ = t;
  valid_until_ = t + (*driven)->validFor();
  return true;
}

bool SolvedMotion::anchorInMedium(const SolvedProblem& same_problem, double t,
                                  const BodyState& state) {
  auto* in_medium = std::get_if<InMedium>(&motion_);
  if (!in_medium) return false;
  (*in_medium)->startAnew(same_problem.wrench, state);
  anchor_ = t;
  valid_until_ = t + (*in_medium)->validFor();
  return true;
}

MotionAnchor SolvedMotion::anchor() const {
  if (const auto* series = std::get_if<Series>(&motion_)) return {anchor_, (*series)->start()};
  if (const auto* driven = std::get_if<Driven>(&motion_)) return {anchor_, (*driven)->start()};
  if (const auto* in_medium = std::get_if<InMedium>(&motion_))
    return {anchor_, (*in_medium)->start()};
  if (const auto* axial = std::get_if<AxialFlight>(&motion_)) return {anchor_, axial->start()};
  return {anchor_, std::get<FreeFlight>(motion_).start()};
}

double SolvedMotion::finiteUntil(const BodyState& state) const {
  return modest_ && isModest(state) ? std::min(valid_until_, anchor_ + kModestTime) : anchor_;
}

double SolvedMotion::smoothUntil(double t) const {
  const auto* in_medium = std::get_if<InMedium>(&motion_);
  return in_medium ? std::min(valid_until_, t + (*in_medium)->smoothFor(t - anchor_))
                   : valid_until_;
}

namespace {

/// [1/s] How fast drag slows a body down; beyond numbers: infinite or none.
double slowedBy(const MediumLoad& load, const Body& body, const BodyState& state) {
  const bool has_drag = load.linear != 0 || load.quadratic != 0 || !load.linear_P.isZero(0) ||
                        !load.quadratic_axes.isZero(0) || !load.angular_P.isZero(0);
  if (!has_drag) return 0;
  const Vector3d w_P = angularVelocity(body.inv_I, state.L_P);
  const double speed = stableNorm(Vector3d(state.p_W / body.mass - load.velocity_W)) +
                       stableNorm(w_P) * stableNorm(load.center_P);
  const double linear = load.linear + load.linear_P.cwiseAbs().maxCoeff() +
                        (load.quadratic + load.quadratic_axes.maxCoeff()) * speed;
  const double arm = stableNorm(load.center_P), inv_I = body.inv_I.maxCoeff();
  return std::max(linear * (1 / body.mass + arm * arm * inv_I),
                  load.angular_P.cwiseAbs().maxCoeff() * inv_I);
}

/// [rad/s] At which a body would swing as a pendulum of buoyancy.
double swungBy(const MediumLoad& load, const Body& body) {
  if (load.lift_W.isZero(0) || load.lift_arm_P.isZero(0)) return 0;
  return std::sqrt(stableNorm(load.lift_W)) * std::sqrt(stableNorm(load.lift_arm_P)) *
         std::sqrt(body.inv_I.maxCoeff());
}

/// What makes a motion fast: at which rate, in which unit.
struct Haste {
  double rate;
  const char *does, *unit, *does_beyond_numbers, *remedy;
};

/// That beyond numbers, or the fastest.
Haste fastestOf(const SolvedProblem& problem, const BodyState& state) {
  const Body& body = problem.body;
  const Haste spin{stableNorm(angularVelocity(body.inv_I, state.L_P)), "it turns", " rad/s",
                   "it turns", "slower turning, or less torque,"};
  if (!problem.wrench.medium) return spin;
  const MediumLoad& load = *problem.wrench.medium;
  const Haste drag{slowedBy(load, body, state), "drag slows it down", "/s", "drag changes it",
                   "weaker drag"};
  const Haste lift{swungBy(load, body), "buoyancy turns it", " rad/s", "buoyancy turns it",
                   "less buoyancy, or a centre nearer to that of mass,"};
  if (!std::isfinite(drag.rate) || drag.rate > std::max(spin.rate, lift.rate)) return drag;
  // swinging over from the top, it turns twice as fast at the bottom
  return !std::isfinite(lift.rate) || 2 * lift.rate > spin.rate ? lift : spin;
}

}  // namespace

std::string tooFastText(const SolvedProblem& problem, const BodyState& state, bool stuck) {
  const Haste fastest = fastestOf(problem, state);
  std::ostringstream text;
  text << "the motion is too fast to be followed";
  if (!std::isfinite(fastest.rate))
    text << ": " << fastest.does_beyond_numbers << " faster than numbers reach";
  else if (fastest.rate > 0)
    text << ": " << fastest.does << " at " << fastest.rate << fastest.unit;
  text << (stuck ? "; " : "; a shorter time_step or ") << fastest.remedy << " is needed";
  return text.str();
}

BodyState SolvedMotion::at(double t) const {
  const double dt = t - anchor_;
  if (const auto* series = std::get_if<Series>(&motion_)) return (*series)->at(dt);
  if (const auto* flight = std::get_if<FreeFlight>(&motion_)) return flight->at(dt);
  if (const auto* axial = std::get_if<AxialFlight>(&motion_)) return axial->at(dt);
  if (const auto* driven = std::get_if<Driven>(&motion_)) return (*driven)->at(dt);
  return (*std::get_if<InMedium>(&motion_))->at(dt);
}

}  // namespace rigid_body_sim
