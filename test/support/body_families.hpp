#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include <rigid_body_sim/math/rotation.hpp>

namespace rigid_body_sim {

/// A free body at one instant: principal moments (ascending), attitude, angular momentum.
struct SpinningBody {
  Vector3d I;
  Quaterniond q_WP;
  Vector3d L_P;

  /// As a state carries it: rounded.
  Vector3d L_W() const { return rotate(q_WP, L_P); }
  double spin() const { return L_P.cwiseQuotient(I).norm(); }  ///< |ω| [rad/s]
};

using Random = std::mt19937_64;

inline double uniform(Random& random, double low, double high) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

/// 10 to a power that is uniform between the two.
inline double powerOfTen(Random& random, double low, double high) {
  return std::pow(10.0, uniform(random, low, high));
}

inline double randomSign(Random& random) { return uniform(random, -1, 1) < 0 ? -1 : 1; }

/// Uniform on the sphere.
inline Vector3d randomDirection(Random& random) {
  std::normal_distribution<double> normal;
  return Vector3d(normal(random), normal(random), normal(random)).normalized();
}

inline Quaterniond randomAttitude(Random& random) {
  std::normal_distribution<double> normal;
  return Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
}

/// Principal moments of a body with second moments of mass ∫x², ∫y², ∫z²: any three that are not
/// negative belong to a body that exists.
inline Vector3d momentsOf(double xx, double yy, double zz) {
  std::array<double, 3> I{yy + zz, zz + xx, xx + yy};
  std::sort(I.begin(), I.end());
  return {I[0], I[1], I[2]};
}

/// Angular momentum on the separatrix, m₁² I21/I1 = m₃² I32/I3, at a random place of it.
inline Vector3d separatrixMomentum(const Vector3d& I, Random& random) {
  const double u = uniform(random, -3, 3);
  const Vector3d across(std::sqrt((I(2) - I(1)) / I(2)), 0, std::sqrt((I(1) - I(0)) / I(0)));
  Vector3d m = across.normalized() / std::cosh(u);
  m.x() *= randomSign(random);
  m.z() *= randomSign(random);
  m.y() = std::tanh(u);
  return m;
}

/// The shapes and motions on which formulas for the free top are known to fail.
enum class BodyFamily {
  generic,
  generic_momentum,
  needle,
  needle_momentum,
  plate,
  near_symmetric,
  near_sphere,
  impossible_ratio,
  near_first_axis,
  near_second_axis,
  near_third_axis,
  one_component_zero,
  separatrix,
  near_separatrix,
  needle_near_separatrix
};

inline const std::vector<std::pair<BodyFamily, std::string>>& bodyFamilies() {
  static const std::vector<std::pair<BodyFamily, std::string>> families = {
      {BodyFamily::generic, "generic"},
      {BodyFamily::generic_momentum, "generic_momentum"},
      {BodyFamily::needle, "needle"},
      {BodyFamily::needle_momentum, "needle_momentum"},
      {BodyFamily::plate, "plate"},
      {BodyFamily::near_symmetric, "near_symmetric"},
      {BodyFamily::near_sphere, "near_sphere"},
      {BodyFamily::impossible_ratio, "impossible_ratio"},
      {BodyFamily::near_first_axis, "near_first_axis"},
      {BodyFamily::near_second_axis, "near_second_axis"},
      {BodyFamily::near_third_axis, "near_third_axis"},
      {BodyFamily::one_component_zero, "one_component_zero"},
      {BodyFamily::separatrix, "separatrix"},
      {BodyFamily::near_separatrix, "near_separatrix"},
      {BodyFamily::needle_near_separatrix, "needle_near_separatrix"}};
  return families;
}

/// Principal moments of a random body of the family.
inline Vector3d randomMoments(BodyFamily family, Random& random) {
  switch (family) {
    case BodyFamily::needle:
    case BodyFamily::needle_momentum:
    case BodyFamily::needle_near_separatrix:
      return momentsOf(1, powerOfTen(random, -12, 0), powerOfTen(random, -12, 0));
    case BodyFamily::plate:
      return momentsOf(uniform(random, 0.1, 1), uniform(random, 0.1, 1),
                       powerOfTen(random, -15, -1));
    case BodyFamily::near_symmetric:
      return momentsOf(1, 1 + powerOfTen(random, -15, -3), powerOfTen(random, -12, 0));
    case BodyFamily::near_sphere: {
      const double apart = powerOfTen(random, -15, -3);
      return momentsOf(1, 1 + apart * uniform(random, 0, 1), 1 + apart);
    }
    case BodyFamily::impossible_ratio: {  // breaks the triangle inequality, solvable all the same
      Vector3d I(powerOfTen(random, -2, 0), powerOfTen(random, -2, 0), 1);
      if (I(0) > I(1)) std::swap(I(0), I(1));
      return I;
    }
    default:
      return momentsOf(uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1));
  }
}

/// Angular momentum of a random motion of the family, of order 1 or of |ω| of order 1.
inline Vector3d randomMomentum(BodyFamily family, const Vector3d& I, Random& random) {
  const auto nearAxis = [&](int axis) {
    const double off = powerOfTen(random, -200, -2);
    Vector3d m =
        off * Vector3d(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
    m(axis) = randomSign(random);
    return m;
  };
  switch (family) {
    case BodyFamily::generic_momentum:
    case BodyFamily::needle_momentum:
      return randomDirection(random);
    case BodyFamily::near_first_axis:
      return nearAxis(0);
    case BodyFamily::near_second_axis:
      return nearAxis(1);
    case BodyFamily::near_third_axis:
      return nearAxis(2);
    case BodyFamily::one_component_zero: {
      Vector3d m = randomDirection(random);
      m(std::uniform_int_distribution<int>(0, 2)(random)) = 0;
      return m;
    }
    case BodyFamily::separatrix:
      return separatrixMomentum(I, random);
    case BodyFamily::near_separatrix:
    case BodyFamily::needle_near_separatrix: {
      Vector3d m = separatrixMomentum(I, random);
      m.x() *= 1 + randomSign(random) * powerOfTen(random, -16, -2);
      return m;
    }
    default:
      return I.cwiseProduct(randomDirection(random));
  }
}

inline SpinningBody randomSpinningBody(BodyFamily family, Random& random) {
  SpinningBody body;
  body.I = randomMoments(family, random);
  body.q_WP = randomAttitude(random);
  body.L_P = randomMomentum(family, body.I, random);
  return body;
}

}  // namespace rigid_body_sim
