#include "dynamics/wrenches/held_wrench.hpp"

#include "math/two_sum.hpp"

namespace rigid_body_sim {

bool HeldWrench::holds(const PointWrench& applied) {
  const auto own = [&applied](std::size_t frame) {
    return frame == applied.body || frame == kOwnBody;
  };
  if (applied.axes == kWorld) return own(applied.point_frame) || applied.point_frame == kWorld;
  return own(applied.axes) && own(applied.point_frame);
}

Wrench HeldWrench::at(const BodyState& state) const {
  Wrench wrench;
  if (is_zero) return wrench;
  wrench.f_W = f_W + rotate(state.q_WP, f_P);
  wrench.tau_W = tau_W;
  wrench.tau_P = tau_P;
  for (const BodyPointForce& force : body_point_forces)
    wrench.tau_P += force.arm_P.cross(rotateBack(state.q_WP, force.force_W));
  for (const WorldPointForce& force : world_point_forces)
    wrench.tau_W += ((force.point_W - state.x_W) - state.x_low_W).cross(force.force_W);
  return wrench;
}

bool HeldWrench::torqueFree() const {
  return f_P.isZero(0) && tau_W.isZero(0) && tau_P.isZero(0) && body_point_forces.empty() &&
         world_point_forces.empty() && !drive && !medium;
}

// Source: Knuth, TAOCP 2, 4.2.2, theorem B, twice.
void HeldWrenchSum::Pair::add(const Vector3d& term) {
  Vector3d rounded_away;
  const Vector3d coarse = twoSum(high, term, rounded_away);
  high = twoSum(coarse, Vector3d(low + rounded_away), low);
}

void HeldWrenchSum::Places::add(const Vector3d& place, const Vector3d& force_W) {
  const auto [entry, is_new] =
      index_.try_emplace({place.x(), place.y(), place.z()}, forces_.size());
  if (is_new) forces_.push_back({place, {}});
  forces_[entry->second].force_W.add(force_W);
}

void HeldWrenchSum::add(const PointWrench& applied) {
  if (applied.axes != kWorld) {  // body axes at a body point
    f_P_.add(applied.force);
    tau_P_.add(applied.point.cross(applied.force));
    tau_P_.add(applied.torque);
    return;
  }
  f_W_.add(applied.force);
  tau_W_.add(applied.torque);
  if (applied.force.isZero(0)) return;
  if (applied.point_frame == kWorld)
    in_world_.add(applied.point, applied.force);
  else if (!applied.point.isZero(0))
    on_body_.add(applied.point, applied.force);
}

HeldWrench HeldWrenchSum::sum() const {
  HeldWrench held;
  Pair tau_W = tau_W_;
  held.body_point_forces = bodyPointForces();
  held.world_point_forces = worldPointForces(tau_W);
  held.f_W = f_W_.high;
  held.tau_W = tau_W.high;
  held.f_P = f_P_.high;
  held.tau_P = tau_P_.high;
  held.is_zero = held.torqueFree() && held.f_W.isZero(0);
  return held;
}

/// More than three are summed into one per world axis:
///   Σ armᵢ × Rᵀ fᵢ = Σ_k (Σᵢ armᵢ f_ik) × Rᵀ e_k
std::vector<HeldWrench::BodyPointForce> HeldWrenchSum::bodyPointForces() const {
  std::vector<HeldWrench::BodyPointForce> forces;
  if (on_body_.forces().size() <= 3) {
    for (const AtPlace& at : on_body_.forces()) forces.push_back({at.place, at.force_W.high});
    return forces;
  }
  for (int k = 0; k < 3; ++k) {
    Pair moment;
    for (const AtPlace& at : on_body_.forces()) {
      moment.add(at.place * at.force_W.high(k));
      moment.add(at.place * at.force_W.low(k));
    }
    forces.push_back({moment.high, Vector3d::Unit(k)});
  }
  return forces;
}

/// More than three are summed into one, at the place of the first, and a couple:
///   Σ (pⱼ − x) × fⱼ = (p₀ − x) × Σ fⱼ + Σ (pⱼ − p₀) × fⱼ
std::vector<HeldWrench::WorldPointForce> HeldWrenchSum::worldPointForces(Pair& tau_W) const {
  std::vector<HeldWrench::WorldPointForce> forces;
  if (in_world_.forces().size() <= 3) {
    for (const AtPlace& at : in_world_.forces()) forces.push_back({at.place, at.force_W.high});
    return forces;
  }
  const Vector3d& place = in_world_.forces().front().place;
  Pair force_W;
  for (const AtPlace& at : in_world_.forces()) {
    for (const Vector3d& part : {at.force_W.high, at.force_W.low}) {
      force_W.add(part);
      tau_W.add((at.place - place).cross(part));
    }
  }
  forces.push_back({place, force_W.high});
  return forces;
}

}  // namespace rigid_body_sim
