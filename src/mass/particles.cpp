#include <rigid_body_sim/mass/particles.hpp>
#include <rigid_body_sim/math/hat.hpp>

#include "math/compensated_sum.hpp"

namespace rigid_body_sim {

Vector3d momentum(const Particle& particle) { return particle.mass * particle.velocity; }

Vector3d momentOfMomentum(const Particle& particle, const Vector3d& point) {
  return (particle.position - point).cross(momentum(particle));
}

Vector3d momentOfForce(const Vector3d& x, const Vector3d& force, const Vector3d& point) {
  return (x - point).cross(force);
}

Matrix3d pointInertia(double mass, const Vector3d& r) {
  // the product first: scaled after it, both halves of the matrix round alike
  const Matrix3d r_hat_squared = hat(r) * hat(r);
  return -mass * r_hat_squared;
}

double mass(const Particles& particles) {
  CompensatedSum<double> m(0);
  for (const Particle& particle : particles) m.add(particle.mass);
  return m.value();
}

Vector3d centerOfMass(const Particles& particles) { return massProperties(particles).com_B; }

Vector3d momentum(const Particles& particles) {
  CompensatedSum<Vector3d> p(Vector3d::Zero());
  for (const Particle& particle : particles) p.add(momentum(particle));
  return p.value();
}

Vector3d angularMomentum(const Particles& particles) {
  const MassProperties whole = massProperties(particles);
  if (whole.mass == 0) return Vector3d::Zero();
  const Vector3d v_cm = momentum(particles) / whole.mass;
  CompensatedSum<Vector3d> L(Vector3d::Zero());
  for (const Particle& particle : particles)
    L.add(momentOfMomentum({particle.mass, particle.position, particle.velocity - v_cm},
                           whole.com_B));
  return L.value();
}

MassProperties massProperties(const Particles& particles) {
  std::vector<MassProperties> points;
  points.reserve(particles.size());
  for (const Particle& particle : particles)
    points.push_back({particle.mass, particle.position, Matrix3d::Zero()});
  return combined(points);
}

}  // namespace rigid_body_sim
