#include <rigid_body_sim/dynamics/buoyancy.hpp>

#include "dynamics/laws/law_rules.hpp"
#include "dynamics/laws/medium_load.hpp"

namespace rigid_body_sim {

Buoyancy::Buoyancy(std::size_t body, double displaced, const Vector3d& centroid_P,
                   const Vector3d& g_W)
    : body_(body), displaced_(displaced), centroid_P_(centroid_P), g_W_(g_W) {
  requireNotNegative("buoyancy", "the mass displaced must be >= 0 kg", displaced);
  requireFinite("buoyancy", "the centroid", centroid_P);
  requireFinite("buoyancy", "gravity", g_W);
}

std::shared_ptr<const ForceLaw> Buoyancy::reindexed(
    const std::function<std::size_t(std::size_t)>& index) const {
  return std::make_shared<Buoyancy>(index(body_), displaced_, centroid_P_, g_W_);
}

/// The volume stays where it is in the body.
std::shared_ptr<const ForceLaw> Buoyancy::reframed(std::size_t /*body*/, const Body& before,
                                                   const Body& after) const {
  auto copy = std::make_shared<Buoyancy>(*this);
  copy->centroid_P_ = frameBefore(before, after) * centroid_P_;
  return copy;
}

void Buoyancy::addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const {
  const Vector3d f_W = -displaced_ * g_W_;
  Wrench& wrench = wrenches[body_];
  wrench.f_W += f_W;
  wrench.tau_P += centroid_P_.cross(rotateBack(at.states[body_].q_WP, f_W));
}

double Buoyancy::potentialEnergy(const Bodies& at) const {
  const BodyState& s = at.states[body_];
  return displaced_ * g_W_.dot(s.x_W + s.x_low_W + rotate(s.q_WP, centroid_P_));
}

/// It swings as a pendulum of the moment ρ V g b.
void Buoyancy::addStiffness(const std::vector<const Body*>& bodies,
                            std::vector<Stiffness>& stiffness) const {
  stiffness[body_].frequency_squared +=
      displaced_ * g_W_.norm() * centroid_P_.norm() * bodies[body_]->inv_I.maxCoeff();
}

void Buoyancy::addMedium(const Bodies& /*at*/, MediumLoad& load) const {
  load.lift_W = -displaced_ * g_W_;
  load.lift_arm_P = centroid_P_;
}

}  // namespace rigid_body_sim
