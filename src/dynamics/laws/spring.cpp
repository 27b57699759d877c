#include <cmath>

#include <rigid_body_sim/dynamics/spring.hpp>

namespace rigid_body_sim {
namespace {

/// Point of an end from the centre of mass of its body; an end in the world has no arm.
Vector3d armOf(const Spring::End& end, const ForceLaw::Bodies& at) {
  if (end.body == kWorld) return Vector3d::Zero();
  return rotate(at.states[end.body].q_WP, end.point);
}

/// What armOf counts from, in two parts of which the second is small.
std::array<Vector3d, 2> originOf(const Spring::End& end, const ForceLaw::Bodies& at) {
  if (end.body == kWorld) return {end.point, Vector3d::Zero()};
  return {at.states[end.body].x_W, at.states[end.body].x_low_W};
}

Vector3d velocityOf(const Spring::End& end, const ForceLaw::Bodies& at) {
  if (end.body == kWorld) return Vector3d::Zero();
  const Body& body = *at.bodies[end.body];
  const BodyState& s = at.states[end.body];
  const Vector3d w_P = angularVelocity(body.inv_I, s.L_P);
  return s.p_W / body.mass + rotate(s.q_WP, Vector3d(w_P.cross(end.point)));
}

/// [1/kg] At most how much a force at the end accelerates it, per newton: with r the point,
///   1/m + Σ |r × eᵢ|²/Iᵢ.
double mobility(const Spring::End& end, const std::vector<const Body*>& bodies) {
  if (end.body == kWorld) return 0;
  const Body& body = *bodies[end.body];
  double sum = 1 / body.mass;
  for (int i = 0; i < 3; ++i)
    sum += end.point.cross(Vector3d::Unit(i)).squaredNorm() * body.inv_I(i);
  return sum;
}

}  // namespace

std::vector<std::size_t> Spring::members() const {
  std::vector<std::size_t> bodies;
  for (const End& end : ends_)
    if (end.body != kWorld) bodies.push_back(end.body);
  return bodies;
}

std::shared_ptr<const ForceLaw> Spring::reindexed(
    const std::function<std::size_t(std::size_t)>& index) const {
  auto copy = std::make_shared<Spring>(*this);
  for (End& end : copy->ends_)
    if (end.body != kWorld) end.body = index(end.body);
  return copy;
}

Spring::Stretch Spring::stretch(const Bodies& at) const {
  // origins are subtracted first: far from the world's origin, the length keeps its digits
  const std::array<Vector3d, 2> from = originOf(ends_[0], at), to = originOf(ends_[1], at);
  const Vector3d d =
      (to[0] - from[0]) + (to[1] - from[1]) + (armOf(ends_[1], at) - armOf(ends_[0], at));
  Stretch s{Vector3d::Zero(), d.norm(), 0};
  if (!(s.length > 0)) return s;
  s.direction_W = d / s.length;
  if (constants_.damping > 0)
    s.rate = s.direction_W.dot(velocityOf(ends_[1], at) - velocityOf(ends_[0], at));
  return s;
}

void Spring::addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const {
  const Stretch s = stretch(at);
  const double tension =
      constants_.stiffness * (s.length - constants_.rest_length) + constants_.damping * s.rate;
  for (std::size_t k = 0; k < 2; ++k) {
    const End& end = ends_[k];
    if (end.body == kWorld) continue;
    const Vector3d f_W = (k == 0 ? tension : -tension) * s.direction_W;
    wrenches[end.body].f_W += f_W;
    wrenches[end.body].tau_P += end.point.cross(rotateBack(at.states[end.body].q_WP, f_W));
  }
}

double Spring::potentialEnergy(const Bodies& at) const {
  const double extension = stretch(at).length - constants_.rest_length;
  return 0.5 * constants_.stiffness * extension * extension;
}

double Spring::reach(const Bodies& at) const {
  double length = stretch(at).length;
  for (const End& end : ends_)
    if (end.body != kWorld) length += end.point.norm();
  return length;
}

double Spring::externalPower(const Bodies& at) const {
  const Stretch s = stretch(at);
  return -constants_.damping * s.rate * s.rate;
}

// The sums of absolute values along the rows of M^(−1/2) K M^(−1/2), which bound its eigenvalues
// (Gershgorin), M being the mass matrix and K the stiffness.
void Spring::addStiffness(const std::vector<const Body*>& bodies,
                          std::vector<Stiffness>& stiffness) const {
  const std::array<double, 2> a{mobility(ends_[0], bodies), mobility(ends_[1], bodies)};
  for (std::size_t k = 0; k < 2; ++k) {
    if (ends_[k].body == kWorld) continue;
    const double row = a[k] + std::sqrt(a[0] * a[1]);
    stiffness[ends_[k].body].frequency_squared += constants_.stiffness * row;
    stiffness[ends_[k].body].decay += constants_.damping * row;
  }
}

}  // namespace rigid_body_sim
