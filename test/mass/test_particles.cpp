#include <cmath>

#include <gtest/gtest.h>

#include <rigid_body_sim/mass/particles.hpp>

#include "support/mass_difference.hpp"
#include "support/random_mass.hpp"

namespace rigid_body_sim {
namespace {

/// Forces of springs between all pairs: equal, opposite and along the line between the two.
std::vector<Vector3d> internalForces(const Particles& particles, RandomMass& random) {
  std::vector<Vector3d> forces(particles.size(), Vector3d::Zero());
  for (std::size_t i = 0; i < particles.size(); ++i)
    for (std::size_t j = i + 1; j < particles.size(); ++j) {
      const Vector3d f = random.uniform(-40, 40) * (particles[j].position - particles[i].position);
      forces[i] += f;
      forces[j] -= f;
    }
  return forces;
}

/// The particles after moving freely for h under constant forces.
Particles after(double h, Particles particles, const std::vector<Vector3d>& forces) {
  for (std::size_t i = 0; i < particles.size(); ++i) {
    Particle& particle = particles[i];
    const Vector3d a = forces[i] / particle.mass;
    particle.position += h * particle.velocity + h * h / 2 * a;
    particle.velocity += h * a;
  }
  return particles;
}

}  // namespace

TEST(PointInertia, HasTheEntriesOfTheLecture) {
  const double m = 3, x = 0.5, y = -0.25, z = 2;  // exact in binary
  Matrix3d expected;
  expected << m * (y * y + z * z), -m * x * y, -m * x * z,  //
      -m * x * y, m * (x * x + z * z), -m * y * z,          //
      -m * x * z, -m * y * z, m * (x * x + y * y);
  EXPECT_EQ(pointInertia(m, {x, y, z}), expected);
}

TEST(PointInertia, IsSymmetricToTheLastBit) {
  RandomMass random(11);
  for (int i = 0; i < 1000; ++i) {
    const Matrix3d I = pointInertia(random.uniform(0, 10), random.vector(1));
    EXPECT_EQ(I, Matrix3d(I.transpose()));
  }
}

TEST(Particle, TurningAboutAPointHasAngularMomentumOfItsInertia) {
  // v = ω × r gives L = r × m v = I ω
  RandomMass random(12);
  for (int i = 0; i < 1000; ++i) {
    const Vector3d center = random.vector(3), r = random.vector(3), w = random.vector(3);
    const Particle particle{random.uniform(0.1, 10), center + r, w.cross(r)};
    const Vector3d L = pointInertia(particle.mass, r) * w;
    EXPECT_LE((momentOfMomentum(particle, center) - L).norm(),
              1e-14 * particle.mass * r.squaredNorm() * w.norm());
  }
}

TEST(Particle, MomentOfForceIsTheRateOfItsMomentOfMomentum) {
  RandomMass random(13);
  const double h = 1e-5;
  for (int i = 0; i < 100; ++i) {
    const Particles one = random.particles(1);
    const Vector3d f = random.vector(10), point = random.vector(3);
    const Vector3d change = momentOfMomentum(after(h, one, {f})[0], point) -
                            momentOfMomentum(after(-h, one, {f})[0], point);
    // L(h) − L(−h) = 2 h τ + h³ (…): 1e-9; rounding of L ~ 100 over h: 1e-9
    EXPECT_LE((change / (2 * h) - momentOfForce(one[0].position, f, point)).norm(), 1e-8);
  }
}

TEST(Particles, HaveTheMassPropertiesOfTheirSums) {
  RandomMass random(14);
  const Particles particles = random.particles(50);
  double m = 0;
  Vector3d mx = Vector3d::Zero();
  for (const Particle& p : particles) {
    m += p.mass;
    mx += p.mass * p.position;
  }
  Matrix3d I = Matrix3d::Zero();
  for (const Particle& p : particles) I += pointInertia(p.mass, p.position - mx / m);
  EXPECT_TRUE(sameMass(massProperties(particles), {m, mx / m, I}, 1e-14));
  EXPECT_NEAR(mass(particles), m, 1e-14 * m);
  EXPECT_LE((centerOfMass(particles) - mx / m).norm(), 1e-15 * 4);
}

TEST(Particles, HaveTheMomentumOfOneAtTheCentreOfMass) {
  RandomMass random(15);
  const double h = 1e-3;
  for (int i = 0; i < 100; ++i) {
    const Particles particles = random.particles(8);
    const std::vector<Vector3d> free(particles.size(), Vector3d::Zero());
    const Vector3d v_cm =
        (centerOfMass(after(h, particles, free)) - centerOfMass(after(-h, particles, free))) /
        (2 * h);
    // free motion is linear in h: rounding of the positions over h alone
    EXPECT_LE((momentum(particles) - mass(particles) * v_cm).norm(), 1e-11 * mass(particles));
  }
}

TEST(Particles, HaveTheAngularMomentumOfTheDefinition) {
  RandomMass random(16);
  for (int i = 0; i < 100; ++i) {
    const Particles particles = random.particles(8);
    Vector3d L = Vector3d::Zero();
    for (const Particle& p : particles) L += momentOfMomentum(p, centerOfMass(particles));
    EXPECT_LE((angularMomentum(particles) - L).norm(), 1e-13 * L.norm() + 1e-12);
  }
}

TEST(Particles, KeepTheirAngularMomentumInAFastFarFrame) {
  RandomMass random(17);
  for (int i = 0; i < 100; ++i) {
    const Particles particles = random.particles(8);
    Particles far = particles;
    for (Particle& p : far) {
      p.position += Vector3d(1e6, -1e6, 1e6);
      p.velocity += Vector3d(1e5, 1e5, -1e5);
    }
    // positions and velocities are rounded to 1e-10 and 1e-11; Σ r × p itself would be off by 1e-4
    EXPECT_LE((angularMomentum(far) - angularMomentum(particles)).norm(), 1e-7);
  }
}

TEST(Particles, DoNotFeelTheirInternalForces) {
  RandomMass random(18);
  for (int i = 0; i < 100; ++i) {
    const Particles particles = random.particles(10);
    const std::vector<Vector3d> forces = internalForces(particles, random);
    Vector3d f = Vector3d::Zero(), tau = Vector3d::Zero();
    for (std::size_t k = 0; k < forces.size(); ++k) {
      f += forces[k];
      tau += momentOfForce(particles[k].position, forces[k], centerOfMass(particles));
    }
    // 45 pairs of up to 300 N at up to 5 m
    EXPECT_LE(f.norm(), 1e-11);
    EXPECT_LE(tau.norm(), 1e-11);
    const Particles later = after(1e-3, particles, forces);
    EXPECT_LE((momentum(later) - momentum(particles)).norm(), 1e-12 * mass(particles));
  }
}

TEST(Particles, ChangeTheirAngularMomentumByTheTorqueOnTheCentreOfMass) {
  // τ_cm = Σ rᵢ × fᵢ, with external forces besides the internal ones
  RandomMass random(19);
  const double h = 1e-5;
  for (int i = 0; i < 100; ++i) {
    const Particles particles = random.particles(6);
    std::vector<Vector3d> forces = internalForces(particles, random);
    Vector3d tau = Vector3d::Zero();
    for (std::size_t k = 0; k < forces.size(); ++k) {
      const Vector3d external = random.vector(10);
      forces[k] += external;
      tau += momentOfForce(particles[k].position, external, centerOfMass(particles));
    }
    const Vector3d rate = (angularMomentum(after(h, particles, forces)) -
                           angularMomentum(after(-h, particles, forces))) /
                          (2 * h);
    // the forces are held while the positions move: h² (…); rounding of L ~ 1e2 over h
    EXPECT_LE((rate - tau).norm(), 1e-7);
  }
}

TEST(Particles, AtTheCornersOfACubeHaveItsClosedForm) {
  Particles corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({0.25, Vector3d(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1), {0, 0, 0}});
  const MassProperties cube = massProperties(corners);
  EXPECT_EQ(cube.mass, 2);
  EXPECT_EQ(cube.com_B, Vector3d::Zero());
  EXPECT_EQ(cube.I_Bcm, Matrix3d(4 * Matrix3d::Identity()));  // 8 m (1² + 1²)
}

TEST(Particles, OfNoMassAreNoBodyAndNoNan) {
  EXPECT_EQ(massProperties(Particles{}).com_B, Vector3d::Zero());
  const Particles massless{{0, {1, 2, 3}, {4, 5, 6}}};
  EXPECT_EQ(massProperties(massless).I_Bcm, Matrix3d::Zero());
  EXPECT_EQ(angularMomentum(massless), Vector3d::Zero());
  EXPECT_EQ(massPropertiesFault(massProperties(massless)), "mass must be > 0 kg, got 0");
}

}  // namespace rigid_body_sim
