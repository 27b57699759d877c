#include <rigid_body_sim/dynamics/solved_motion.hpp>

namespace rigid_body_sim {

SolvedMotion::SolvedMotion(const Body& body, const HeldWrench& wrench, const Vector3d& g_W,
                           double t, const BodyState& state, double horizon,
                           const ErrorBound& bound)
    : anchor_(t), motion_(TaylorPointer()) {
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

BodyState SolvedMotion::at(double t) const {
  const double dt = t - anchor_;
  if (const auto* segment = std::get_if<TaylorPointer>(&motion_)) return (*segment)->at(dt);
  return std::get<FreeFlight>(motion_).at(dt);
}

}  // namespace rigid_body_sim
