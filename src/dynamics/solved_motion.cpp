#include <limits>

#include <rigid_body_sim/dynamics/solved_motion.hpp>

namespace rigid_body_sim {

SolvedMotion::SolvedMotion(const Body& body, const HeldWrench& wrench, const Vector3d& g_W,
                           double t, const BodyState& state, double horizon,
                           const ErrorBound& bound)
    : anchor_(t), motion_(TaylorPointer()) {
  if (wrench.torqueFree())
    motion_ = FreeFlight(body, wrench.f_W + body.mass * g_W, state);
  else
    motion_ = std::make_shared<const TaylorSegment>(body, wrench, g_W, state, horizon, bound);
}

double SolvedMotion::validUntil() const {
  if (const auto* segment = std::get_if<TaylorPointer>(&motion_))
    return anchor_ + (*segment)->validFor();
  return std::numeric_limits<double>::infinity();
}

BodyState SolvedMotion::at(double t) const {
  const double dt = t - anchor_;
  if (const auto* segment = std::get_if<TaylorPointer>(&motion_)) return (*segment)->at(dt);
  return std::get<FreeFlight>(motion_).at(dt);
}

}  // namespace rigid_body_sim
