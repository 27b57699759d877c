#include "dynamics/wrenches/held_wrench.hpp"

#include <algorithm>

namespace rigid_body_sim {
namespace {

/// sum + lost += term, and again sum is as near to the whole as a double can be.
/// Source: Knuth, TAOCP 2, 4.2.2, theorem B, twice.
void addTo(Vector3d& sum, Vector3d& lost, const Vector3d& term) {
  const auto twoSum = [](const Vector3d& a, const Vector3d& b, Vector3d& rounded_away) {
    const Vector3d whole = a + b;
    const Vector3d part = whole - a;
    rounded_away = (a - (whole - part)) + (b - part);
    return whole;
  };
  Vector3d rounded_away;
  const Vector3d coarse = twoSum(sum, term, rounded_away);
  sum = twoSum(coarse, Vector3d(lost + rounded_away), lost);
}

/// Adds a force to what acts at the same place already; returns whether something does.
template <class Applied>
bool addAtSamePlace(const Vector3d& place, Vector3d Applied::*place_of, const Vector3d& force_W,
                    std::vector<Applied>& acting) {
  const auto same = std::find_if(acting.begin(), acting.end(),
                                 [&](const Applied& a) { return a.*place_of == place; });
  if (same == acting.end()) return false;
  addTo(same->force_W, same->lost_W, force_W);
  return true;
}

/// Levers summed into one per world axis:  Σ armᵢ × Rᵀ fᵢ = Σ_k (Σᵢ armᵢ f_ik) × Rᵀ e_k.
std::vector<HeldWrench::Lever> mergedLevers(const std::vector<HeldWrench::Lever>& levers) {
  Matrix3d moments = Matrix3d::Zero();
  for (const HeldWrench::Lever& lever : levers) moments += lever.arm_P * lever.force_W.transpose();
  std::vector<HeldWrench::Lever> merged;
  for (int k = 0; k < 3; ++k) merged.push_back({moments.col(k), Vector3d::Unit(k)});
  return merged;
}

}  // namespace

bool HeldWrench::holds(const PointWrench& applied) {
  const bool own_axes = applied.axes == applied.body;
  const bool own_point = applied.point_frame == applied.body;
  if (own_axes) return own_point;
  return applied.axes == kWorld && (own_point || applied.point_frame == kWorld);
}

void HeldWrench::add(const PointWrench& applied) {
  if (applied.axes == applied.body) {
    addTo(f_P, f_lost_P_, applied.force);
    addTo(tau_P, tau_lost_P_, applied.point.cross(applied.force));
    addTo(tau_P, tau_lost_P_, applied.torque);
    return;
  }
  addTo(f_W, f_lost_W_, applied.force);
  addTo(tau_W, tau_lost_W_, applied.torque);
  if (applied.force.isZero(0)) return;
  if (applied.point_frame == kWorld) {
    if (addAtSamePlace(applied.point, &Pull::point_W, applied.force, pulls)) return;
    pulls.push_back({applied.point, applied.force});
    if (pulls.size() > 3) mergePulls();
  } else if (!applied.point.isZero(0)) {
    if (addAtSamePlace(applied.point, &Lever::arm_P, applied.force, levers)) return;
    levers.push_back({applied.point, applied.force});
    if (levers.size() > 3) levers = mergedLevers(levers);
  }
}

/// Σ (pⱼ − x) × fⱼ = (p₀ − x) × Σ fⱼ + Σ (pⱼ − p₀) × fⱼ
void HeldWrench::mergePulls() {
  Pull& first = pulls.front();
  for (std::size_t j = 1; j < pulls.size(); ++j) {
    for (const Vector3d& force_W : {pulls[j].force_W, pulls[j].lost_W}) {
      addTo(first.force_W, first.lost_W, force_W);
      addTo(tau_W, tau_lost_W_, (pulls[j].point_W - first.point_W).cross(force_W));
    }
  }
  pulls.resize(1);
}

Wrench HeldWrench::at(const BodyState& state) const {
  Wrench wrench;
  wrench.f_W = f_W + rotate(state.q_WP, f_P);
  wrench.tau_W = tau_W;
  wrench.tau_P = tau_P;
  for (const Lever& lever : levers)
    wrench.tau_P += lever.arm_P.cross(rotateBack(state.q_WP, lever.force_W));
  for (const Pull& pull : pulls)
    wrench.tau_W += ((pull.point_W - state.x_W) - state.x_low_W).cross(pull.force_W);
  return wrench;
}

bool HeldWrench::torqueFree() const {
  return f_P.isZero(0) && tau_W.isZero(0) && tau_P.isZero(0) && levers.empty() && pulls.empty();
}

}  // namespace rigid_body_sim
