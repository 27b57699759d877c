#include <algorithm>
#include <cmath>

#include "dynamics/medium/medium_series.hpp"

namespace rigid_body_sim {
namespace {

/// One pass through the degrees. Sums over i of products of degrees i and n − i.
class MediumRecursion {
 public:
  MediumRecursion(const MediumEquations& equations, MediumSeries& series)
      : e_(equations), s_(series), translates_(equations.load.isOfTranslation()) {}

  void advance(std::size_t n) {
    const double unit = 1 / (e_.rate * static_cast<double>(n + 1));
    const Vector3d f_W = addForces(n);
    addTorques(n);
    turn(n, unit);
    const Vector3d first = n == 0 ? Vector3d(e_.a_W) : Vector3d(Vector3d::Zero());
    s_.v[n + 1] = unit * (first + e_.inv_mass * f_W);
    s_.x[n + 1] = unit * (n == 0 ? Vector3d(s_.v[0] + e_.load.velocity_W) : s_.v[n]);
    s_.twist[n + 1] = unit * (torque_W_[n] + turnedBack(torque_P_, n));
  }

 private:
  /// The coefficient n of the forces that motion and attitude change, world axes [N]; keeps those
  /// in principal axes.
  Vector3d addForces(std::size_t n) {
    const MediumLoad& load = e_.load;
    force_P_[n] = n == 0 ? e_.f_P : Vector3d::Zero();
    drag_P_[n].setZero();
    if (translates_) {
      s_.u[n] = s_.v[n];
      const Vector3d drag_W = -load.linear * s_.v[n] - squared(n);
      return e_.f_P.isZero(0) ? drag_W : Vector3d(drag_W + turnedBack(force_P_, n));
    }
    Vector3d u_P = s_.w[n].cross(load.center_P);
    for (std::size_t i = 0; i <= n; ++i) u_P += s_.axes[i] * s_.v[n - i];
    s_.u[n] = load.R_PD.transpose() * u_P;
    const Vector3d along_D = squared(n) + squaredAlongAxes(n);
    drag_P_[n] = -load.linear * u_P - load.linear_P * u_P - load.R_PD * along_D;
    force_P_[n] += drag_P_[n];
    return turnedBack(force_P_, n);
  }

  /// Those fixed in the world, and all others in principal axes.
  void addTorques(std::size_t n) {
    torque_W_[n] = n == 0 ? e_.tau_W : Vector3d::Zero();
    if (n > 0) torque_W_[n] -= s_.x[n].cross(e_.pull_W);
    Vector3d& torque = torque_P_[n];
    torque = e_.load.center_P.cross(drag_P_[n]) - e_.load.angular_P * s_.w[n];
    if (n == 0) torque += e_.tau_P;
    for (int j = 0; j < 3; ++j) {
      const Vector3d arm = e_.moments.col(j), axis = s_.axes[n].col(j);
      torque += arm.cross(axis);
    }
  }

  void turn(std::size_t n, double unit) {
    Vector3d L_dot = torque_P_[n];
    Eigen::Vector4d q_dot = Eigen::Vector4d::Zero();
    Matrix3d axes_dot = Matrix3d::Zero();
    for (std::size_t i = 0; i <= n; ++i) {
      const Vector3d& w = s_.w[n - i];
      const Eigen::Vector4d& q = s_.q[i];
      const Vector3d vector = q.head<3>(), L = e_.I.cwiseProduct(s_.w[i]);
      L_dot += L.cross(w) + s_.axes[i] * torque_W_[n - i];
      q_dot.head<3>() += q[3] * w + vector.cross(w);
      q_dot[3] -= vector.dot(w);
      for (int j = 0; j < 3; ++j) {
        const Vector3d axis = s_.axes[i].col(j);
        axes_dot.col(j) += axis.cross(w);
      }
    }
    s_.w[n + 1] = unit * e_.inv_I.cwiseProduct(L_dot);
    s_.q[n + 1] = 0.5 * unit * q_dot;
    s_.axes[n + 1] = unit * axes_dot;
  }

  /// The coefficient n of R y, y in principal axes.
  Vector3d turnedBack(const MediumSeries::Of<Vector3d>& y_P, std::size_t n) const {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i <= n; ++i) sum += s_.axes[i].transpose() * y_P[n - i];
    return sum;
  }

  /// The coefficient n of c |u| u [N]: with z = u · u, |u|_n = (z_n − Σ_{0<i<n} |u|_i |u|_{n−i})/(2
  /// |u|_0).
  Vector3d squared(std::size_t n) {
    if (e_.load.quadratic == 0 || e_.drops_quadratic) return Vector3d::Zero();
    scaled_u_[n] = s_.u[n] / e_.speed_unit;
    double z = 0;
    for (std::size_t i = 0; i <= n; ++i) z += scaled_u_[i].dot(scaled_u_[n - i]);
    for (std::size_t i = 1; i < n; ++i) z -= speed_[i] * speed_[n - i];
    speed_[n] = n == 0 ? std::sqrt(z) : z / (2 * speed_[0]);
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i <= n; ++i) sum += speed_[i] * scaled_u_[n - i];
    return (e_.load.quadratic * e_.speed_unit) * (e_.speed_unit * sum);
  }

  /// The coefficient n of c_i |u_i| u_i [N].
  Vector3d squaredAlongAxes(std::size_t n) {
    if (e_.load.quadratic_axes.isZero(0)) return Vector3d::Zero();
    findSigns(n);
    scaled_u_[n] = s_.u[n] / e_.speed_unit;
    Vector3d sum = Vector3d::Zero();
    for (std::size_t i = 0; i <= n; ++i) sum += scaled_u_[i].cwiseProduct(scaled_u_[n - i]);
    sum = e_.speed_unit * s_.signs.cwiseProduct(sum);
    return (e_.speed_unit * e_.load.quadratic_axes).cwiseProduct(sum);
  }

  /// By the first coefficient that counts: right after a change of sign the lowest is rounding, and
  /// likewise where the body moves along another axis.
  void findSigns(std::size_t n) {
    const double speed = speedOf(s_.u[0]);
    for (int i = 0; i < 3; ++i) {
      const double u = s_.u[n][i];
      const bool starts_at_zero =
          n == 1 && std::abs(s_.u[0][i]) <= kZeroShare * std::max(std::abs(u), speed);
      if (u != 0 && (s_.signs[i] == 0 || starts_at_zero)) s_.signs[i] = u > 0 ? 1 : -1;
    }
  }

  const MediumEquations& e_;
  MediumSeries& s_;
  bool translates_;
  MediumSeries::Of<Vector3d> force_P_, drag_P_, torque_P_, torque_W_;
  MediumSeries::Of<Vector3d> scaled_u_;  // in speed_unit, as the next
  MediumSeries::Of<double> speed_;
};

}  // namespace

void expandMedium(const MediumEquations& equations, MediumSeries& series) {
  series.x[0].setZero();
  series.twist[0].setZero();
  series.signs.setZero();
  MediumRecursion recursion(equations, series);
  for (std::size_t n = 0; n < MediumSeries::kDegree; ++n) recursion.advance(n);
}

}  // namespace rigid_body_sim
