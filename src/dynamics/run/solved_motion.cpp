#include "dynamics/run/solved_motion.hpp"

#include <algorithm>

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

bool isModest(const HeldWrench& wrench) {
  const auto lever = [](const HeldWrench::Lever& l) {
    return isModest(l.arm_P) && isModest(l.force_W);
  };
  const auto pull = [](const HeldWrench::Pull& p) {
    return isModest(p.point_W) && isModest(p.force_W);
  };
  return isModest(wrench.f_W) && isModest(wrench.tau_W) && isModest(wrench.f_P) &&
         isModest(wrench.tau_P) && std::all_of(wrench.levers.begin(), wrench.levers.end(), lever) &&
         std::all_of(wrench.pulls.begin(), wrench.pulls.end(), pull);
}

}  // namespace

SolvedMotion::SolvedMotion(const Body& body, const HeldWrench& wrench, const Vector3d& g_W,
                           double t, const BodyState& state, double horizon,
                           const ErrorBound& bound)
    : anchor_(t),
      modest_(isModest(body) && isModest(wrench) && isModest(g_W)),
      motion_(TaylorPointer()) {
  if (wrench.torqueFree()) {
    // [rad] the angle is reduced in 64 bits, 5e-20 of it: beyond, 1e-4 rad are lost
    constexpr double kMostTurn = 1e15;
    motion_ = FreeFlight(body, wrench.f_W + body.mass * g_W, state);
    valid_until_ = t + kMostTurn / angularVelocity(body.inv_I, state.L_P).stableNorm();
  } else {
    motion_ = std::make_shared<TaylorSegment>(body, wrench, g_W, state, horizon, bound);
    valid_until_ = t + std::get<TaylorPointer>(motion_)->validFor();
  }
}

void SolvedMotion::anchorAnew(const Body& body, const HeldWrench& wrench, const Vector3d& g_W,
                              double t, const BodyState& state, double horizon,
                              const ErrorBound& bound) {
  const auto* segment = std::get_if<TaylorPointer>(&motion_);
  if (!segment || wrench.torqueFree() || segment->use_count() > 1) {
    *this = SolvedMotion(body, wrench, g_W, t, state, horizon, bound);
    return;
  }
  (*segment)->startAnew(wrench, state, horizon);
  anchor_ = t;
  valid_until_ = t + (*segment)->validFor();
}

double SolvedMotion::finiteUntil(const BodyState& state) const {
  return modest_ && isModest(state) ? std::min(valid_until_, anchor_ + kModestTime) : anchor_;
}

BodyState SolvedMotion::at(double t) const {
  const double dt = t - anchor_;
  if (const auto* segment = std::get_if<TaylorPointer>(&motion_)) return (*segment)->at(dt);
  return std::get<FreeFlight>(motion_).at(dt);
}

}  // namespace rigid_body_sim
