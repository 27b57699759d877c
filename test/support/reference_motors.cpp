#include "support/reference_motors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>

namespace rigid_body_sim::reference {

MotorMotion::MotorMotion(MotorBody body, const BodyFrameMotion& start) : body_(std::move(body)) {
  WideMatrix I = body_.properties_B.I_Bcm.cast<Wide>();
  const WideVector w_B = (start.q_WB.conjugate() * start.w_W).cast<Wide>();
  y_ = Unknowns::Zero(kFirst + static_cast<int>(body_.actuators.size()));
  WideVector L_B = I * w_B;
  for (std::size_t k = 0; k < body_.actuators.size(); ++k) {
    Wide& value = y_[kFirst + static_cast<int>(k)];
    if (const auto* wheel = std::get_if<Wheel>(&body_.actuators[k].kind)) {
      const WideVector a = wheel->axis_B.cast<Wide>();
      value = Wide(wheel->inertia) * (Wide(wheel->speed) + a.dot(w_B));
      I -= Wide(wheel->inertia) * a * a.transpose();
      L_B += Wide(wheel->inertia) * Wide(wheel->speed) * a;
    } else if (const auto* rotor = std::get_if<Rotor>(&body_.actuators[k].kind)) {
      value = Wide(rotor->speed);
      L_B += Wide(rotor->inertia * rotor->turns) * value * rotor->direction_B.cast<Wide>();
    }
  }
  inv_I_ = I.inverse();
  commands_.assign(body_.actuators.size(), 0);
  const Quaternion<Wide> q = start.q_WB.cast<Wide>().normalized();
  const WideMatrix R = q.toRotationMatrix();
  const WideVector com = R * body_.properties_B.com_B.cast<Wide>();
  y_.segment<3>(0) = start.x_W.cast<Wide>() + com;
  y_.segment<3>(3) =
      Wide(body_.properties_B.mass) * (start.v_W.cast<Wide>() + start.w_W.cast<Wide>().cross(com));
  y_.segment<4>(6) = q.coeffs();
  y_.segment<3>(10) = R * L_B;
}

WideVector MotorMotion::position() const { return y_.segment<3>(0); }
WideVector MotorMotion::velocity() const {
  return y_.segment<3>(3) / Wide(body_.properties_B.mass);
}
Quaternion<Wide> MotorMotion::attitude() const { return attitudeOf(y_); }
WideVector MotorMotion::momentum() const { return y_.segment<3>(10); }
WideVector MotorMotion::angularVelocity() const { return turning(y_); }
Wide MotorMotion::value(std::size_t k) const { return y_[kFirst + static_cast<int>(k)]; }

void MotorMotion::advance(Wide duration, Wide first_step) {
  Wide h = std::min(first_step, duration);
  for (Wide done = 0; done < duration;) {
    h = std::min(h, duration - done);
    Unknowns end;
    if (!extrapolate(h, end)) {
      h /= 2;
      if (!(h > duration * 1e-12L)) throw std::runtime_error("reference motors: no step converges");
      continue;
    }
    y_ = end;
    y_.segment<4>(6).normalize();
    done += h;
    h *= 1.5L;
  }
}

Quaternion<Wide> MotorMotion::attitudeOf(const Unknowns& y) {
  return Quaternion<Wide>(y[9], y[6], y[7], y[8]).normalized();
}

WideVector MotorMotion::turning(const Unknowns& y) const {
  WideVector rest = attitudeOf(y).toRotationMatrix().transpose() * WideVector(y.segment<3>(10));
  for (std::size_t k = 0; k < body_.actuators.size(); ++k) {
    const Wide value = y[kFirst + static_cast<int>(k)];
    if (const auto* wheel = std::get_if<Wheel>(&body_.actuators[k].kind))
      rest -= value * wheel->axis_B.cast<Wide>();
    else if (const auto* rotor = std::get_if<Rotor>(&body_.actuators[k].kind))
      rest -= Wide(rotor->inertia * rotor->turns) * value * rotor->direction_B.cast<Wide>();
  }
  return inv_I_ * rest;
}

Unknowns MotorMotion::rate(const Unknowns& y) const {
  Unknowns dot = Unknowns::Zero(y.size());
  const Wide m = Wide(body_.properties_B.mass);
  const WideVector w = turning(y), com = body_.properties_B.com_B.cast<Wide>();
  WideVector force = WideVector::Zero(), torque = force;
  for (std::size_t k = 0; k < body_.actuators.size(); ++k) {
    const int at = kFirst + static_cast<int>(k);
    if (const auto* rotor = std::get_if<Rotor>(&body_.actuators[k].kind)) {
      const WideVector d = rotor->direction_B.cast<Wide>();
      const Wide square = y[at] * std::abs(y[at]);
      const WideVector thrust = Wide(rotor->thrust) * square * d;
      force += thrust;
      torque += (rotor->position_B.cast<Wide>() - com).cross(thrust) -
                Wide(rotor->turns) * Wide(rotor->drag_torque) * square * d;
      dot[at] = (commands_[k] - y[at]) / Wide(rotor->time_constant);
    } else if (const auto* thruster = std::get_if<Thruster>(&body_.actuators[k].kind)) {
      const WideVector push = y[at] * thruster->direction_B.cast<Wide>();
      force += push;
      torque += (thruster->position_B.cast<Wide>() - com).cross(push);
      dot[at] = (commands_[k] - y[at]) / Wide(thruster->time_constant);
    } else {
      dot[at] = commands_[k];
    }
  }
  const Quaternion<Wide> q(y[9], y[6], y[7], y[8]);
  const WideMatrix R = attitudeOf(y).toRotationMatrix();
  dot.segment<3>(0) = y.segment<3>(3) / m;
  dot.segment<3>(3) = m * body_.g_W.cast<Wide>() + R * force;
  dot.segment<4>(6) = (q * Quaternion<Wide>(0, w.x(), w.y(), w.z())).coeffs() / 2;
  dot.segment<3>(10) = R * torque;
  return dot;
}

Unknowns MotorMotion::midpoint(Wide h, int n, const Unknowns& start_rate) const {
  const Wide step = h / static_cast<Wide>(n);
  Unknowns before = y_, now = y_ + step * start_rate;
  for (int i = 1; i < n; ++i) {
    Unknowns next = before + 2 * step * rate(now);
    before = std::move(now);
    now = std::move(next);
  }
  return (now + before + step * rate(now)) / 2;
}

bool MotorMotion::extrapolate(Wide h, Unknowns& end) const {
  constexpr int kColumns = 9;
  const Unknowns start_rate = rate(y_);
  std::array<Unknowns, kColumns> table;
  Wide last_error = 1;
  for (int row = 0; row < kColumns; ++row) {
    Unknowns entry = midpoint(h, 2 * (row + 1), start_rate);
    for (int k = 0; k < row; ++k) {
      const Wide ratio = static_cast<Wide>(row + 1) / static_cast<Wide>(row - k);
      const Unknowns gain = entry - table[static_cast<std::size_t>(k)];
      table[static_cast<std::size_t>(k)] = entry;
      entry += gain / (ratio * ratio - 1);
    }
    table[static_cast<std::size_t>(row)] = entry;
    if (row == 0) continue;
    const Wide error = worst(entry, table[static_cast<std::size_t>(row - 1)]);
    end = entry;
    if (error <= 3e-18L || (error < 1e-14L && error > last_error / 2)) return true;
    last_error = error;
  }
  return false;
}

Wide MotorMotion::worst(const Unknowns& a, const Unknowns& b) const {
  Wide greatest = 0;
  for (int i = 0; i < a.size(); ++i)
    greatest = std::max(greatest, std::abs(a[i] - b[i]) / std::max<Wide>(scale_, std::abs(a[i])));
  return greatest;
}

double attitudeGap(const BodyFrameMotion& motion, const MotorMotion& reference) {
  const Quaternion<Wide> d =
      motion.q_WB.cast<Wide>().normalized().conjugate() * reference.attitude();
  return static_cast<double>(2 * std::atan2(d.vec().norm(), std::abs(d.w())));
}

double positionGap(const BodyState& state, const MotorMotion& reference) {
  return static_cast<double>(
      (state.x_W.cast<Wide>() + state.x_low_W.cast<Wide>() - reference.position()).norm());
}

}  // namespace rigid_body_sim::reference
