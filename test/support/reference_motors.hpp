#pragma once

#include <cstddef>
#include <vector>

#include <rigid_body_sim/dynamics/simulation.hpp>

/// An independent reference for a body with motors: the momenta in the world, the body's own axes
/// with full inertia matrices, and the lags as unknowns among the others, in long double, by
/// extrapolation of the modified midpoint rule. The product carries L_P in principal axes and has
/// the lags in closed form.
namespace rigid_body_sim::reference {

using Wide = long double;
using WideVector = Vector3<Wide>;
using WideMatrix = Matrix3<Wide>;
using Unknowns = Eigen::Matrix<Wide, Eigen::Dynamic, 1>;

/// The body frame's mass properties and actuators, as a user gives them.
struct MotorBody {
  MassProperties properties_B;
  std::vector<Actuator> actuators;
  Vector3d g_W = Vector3d::Zero();
};

/// Unknowns: 0 centre of mass, 3 momentum, 6 attitude of B (x, y, z, w), 10 angular momentum in the
/// world, 13 a value of each actuator.
class MotorMotion {
 public:
  static constexpr int kFirst = 13;

  MotorMotion(MotorBody body, const BodyFrameMotion& start);

  void command(std::size_t actuator, double u) { commands_[actuator] = Wide(u); }

  WideVector position() const;
  WideVector velocity() const;
  Quaternion<Wide> attitude() const;
  WideVector momentum() const;
  WideVector angularVelocity() const;
  Wide value(std::size_t k) const;

  /// Advances with the present commands. Speeds must not change their sign meanwhile.
  void advance(Wide duration, Wide first_step);

 private:
  static Quaternion<Wide> attitudeOf(const Unknowns& y);
  WideVector turning(const Unknowns& y) const;
  Unknowns rate(const Unknowns& y) const;
  Unknowns midpoint(Wide h, int n, const Unknowns& start_rate) const;

  /// Source: Hairer, Nørsett, Wanner, "Solving Ordinary Differential Equations I", II.9.
  bool extrapolate(Wide h, Unknowns& end) const;

  Wide worst(const Unknowns& a, const Unknowns& b) const;

  static constexpr Wide scale_ = 1e-3L;
  MotorBody body_;
  WideMatrix inv_I_;
  std::vector<Wide> commands_;
  Unknowns y_;
};

/// [rad] Between a computed attitude of B and the reference's.
double attitudeGap(const BodyFrameMotion& motion, const MotorMotion& reference);

/// [m] Between a computed centre of mass and the reference's.
double positionGap(const BodyState& state, const MotorMotion& reference);

}  // namespace rigid_body_sim::reference
