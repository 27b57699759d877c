#pragma once

#include <random>
#include <vector>

#include <rigid_body_sim/mass/mass_properties.hpp>
#include <rigid_body_sim/mass/particles.hpp>

namespace rigid_body_sim {

/// Random input of the mass tests; every generator is given its seed. The draws are sequenced
/// statement by statement, so that every compiler makes the same bodies.
class RandomMass {
 public:
  explicit RandomMass(unsigned seed) : rng_(seed) {}

  double uniform(double low, double high) {
    return low + (high - low) * (static_cast<double>(rng_()) / 4294967295.0);
  }

  /// Coordinates uniform in ±size.
  Vector3d vector(double size) {
    Vector3d v;
    for (int i = 0; i < 3; ++i) v[i] = uniform(-size, size);
    return v;
  }

  /// Uniform over all rotations: a normal quaternion from six uniform draws a coordinate.
  Matrix3d rotation() {
    Quaterniond q;
    for (int i = 0; i < 4; ++i) {
      double sum = 0;
      for (int k = 0; k < 6; ++k) sum += uniform(-1, 1);
      q.coeffs()[i] = sum;
    }
    return q.normalized().toRotationMatrix();
  }

  Isometry3d isometry(double distance) {
    Isometry3d X = Isometry3d::Identity();
    X.linear() = rotation();
    X.translation() = vector(distance);
    return X;
  }

  /// A box somewhere, turned somehow.
  MassProperties part(double distance) {
    const Vector3d s2 = (vector(1) + Vector3d::Constant(1.1)).cwiseAbs2();
    const double m = uniform(0.1, 10);
    const Matrix3d I =
        (m / 12 * Vector3d(s2.y() + s2.z(), s2.x() + s2.z(), s2.x() + s2.y())).asDiagonal();
    return transformed(isometry(distance), {m, Vector3d::Zero(), I});
  }

  Particles particles(int count) {
    Particles all;
    for (int i = 0; i < count; ++i) {
      Particle particle;
      particle.mass = uniform(0.1, 10);
      particle.position = vector(2);
      particle.velocity = vector(3);
      all.push_back(particle);
    }
    return all;
  }

  std::mt19937& generator() { return rng_; }

 private:
  std::mt19937 rng_;
};

}  // namespace rigid_body_sim
