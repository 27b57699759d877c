#include <cmath>
#include <cstdio>

#include "benchmark/peers_wide.hpp"
#include "benchmark/touch_peers.hpp"

// A rattleback, and the truth of it: pure rolling, in long double, with nothing of ours or of the
// engines.

namespace rigid_body_sim::touch_peers {
namespace {

using namespace wide;
using Numbers = std::array<Real, 7>;  // attitude x y z w, turning in principal axes

V scaled(const V& d, const V& a) { return {d[0] * a[0], d[1] * a[1], d[2] * a[2]}; }
V aboutZ(Real c, Real s, const V& a) { return {c * a[0] - s * a[1], s * a[0] + c * a[1], a[2]}; }

/// x of A x = b, where A has these columns.
V solve(const V& a0, const V& a1, const V& a2, const V& b) {
  const Real det = dot(a0, cross(a1, a2));
  return {dot(b, cross(a1, a2)) / det, dot(a0, cross(b, a2)) / det, dot(a0, cross(a1, b)) / det};
}

/// The third row of the rotation.
V upSeenFrom(const Numbers& y) {
  const V u{y[0], y[1], y[2]};
  const Real s = y[3];
  return (1 / (dot(u, u) + s * s)) * V{2 * (u[0] * u[2] - s * u[1]), 2 * (u[1] * u[2] + s * u[0]),
                                       s * s + u[2] * u[2] - u[0] * u[0] - u[1] * u[1]};
}

/// With r from the centre of mass to the point of contact, and v = −ω × r, of 1 kg:
///   I ω' − r × (r × ω') = r × (g n − ω × (ω × r + r')) − ω × I ω,   n: up, all in principal axes.
class Rolling {
 public:
  explicit Rolling(const TouchCase& c)
      : d_{c.semi_axes[0], c.semi_axes[1], c.semi_axes[2]},
        I_{c.inertia[0], c.inertia[1], c.inertia[2]},
        up_(c.shape_up),
        cos_(std::cos(Real{c.shape_turn})),
        sin_(std::sin(Real{c.shape_turn})) {}

  /// n: up, seen from the body.
  V arm(const V& n) const {
    const V dn = scaled(d_, intoShape(n));
    return V{0, 0, up_} - fromShape((1 / std::sqrt(dot(dn, dn))) * scaled(d_, dn));
  }

  Numbers rate(const Numbers& y) const {
    const V u{y[0], y[1], y[2]}, w{y[4], y[5], y[6]};
    const V n = upSeenFrom(y);
    const V dn = scaled(d_, intoShape(n)), dn_dot = scaled(d_, intoShape(cross(n, w)));
    const Real length = std::sqrt(dot(dn, dn));
    const V r = arm(n);
    const V r_dot = fromShape((dot(dn, dn_dot) / (length * length * length)) * scaled(d_, dn) -
                              (1 / length) * scaled(d_, dn_dot));
    const V push = Real{kGravity} * n - cross(w, cross(w, r) + r_dot);
    const V b = cross(r, push) - cross(w, scaled(I_, w));
    const auto column = [&](std::size_t i) {
      V e{};
      e[i] = 1;
      return scaled(I_, e) - cross(r, cross(r, e));
    };
    const V w_dot = solve(column(0), column(1), column(2), b);
    const V u_dot = Real{0.5} * (y[3] * w + cross(u, w));
    return {u_dot[0], u_dot[1], u_dot[2], -dot(u, w) / 2, w_dot[0], w_dot[1], w_dot[2]};
  }

 private:
  V intoShape(const V& a) const { return aboutZ(cos_, -sin_, a); }
  V fromShape(const V& a) const { return aboutZ(cos_, sin_, a); }

  V d_, I_;
  Real up_, cos_, sin_;
};

Numbers rolled(const TouchCase& c, const Numbers& y, int steps) {
  const Rolling rolling(c);
  return advanced(y, 0, Real{c.duration} / steps, steps,
                  [&](Real, const Numbers& now) { return rolling.rate(now); });
}

Quaternion4 attitude(const Numbers& y) {
  const Real norm = std::sqrt(y[0] * y[0] + y[1] * y[1] + y[2] * y[2] + y[3] * y[3]);
  Quaternion4 q{};
  for (std::size_t i = 0; i < 4; ++i) q[i] = static_cast<double>(y[i] / norm);
  return q;
}

/// The body: Kane & Levinson, Int. J. Non-Linear Mech. 17 (1982) 175.
TouchCase rattlebackAtRest() {
  TouchCase c;
  c.name = "rattleback, 2 s";
  c.semi_axes = {0.2, 0.03, 0.02};
  constexpr double kXx = 2e-4, kYy = 16e-4, kXy = -2e-5;  // in axes of the ellipsoid
  const double mean = (kXx + kYy) / 2, half = std::hypot((kYy - kXx) / 2, kXy);
  c.inertia = {mean - half, mean + half, 17e-4};
  c.shape_up = 0.01;
  c.shape_turn = -std::atan(2 * kXy / (kXx - kYy)) / 2;
  c.friction = 2;
  c.duration = 2;
  c.has_truth = true;
  return c;
}

}  // namespace

/// Tilted by half a degree about both of its long axes, it is spun the way that it does not like,
/// and rolls.
TouchCase rattleback() {
  TouchCase c = rattlebackAtRest();
  constexpr Real kTilt = 0.0043633, kSpin = -5;
  const Real turn = -c.shape_turn, cos = std::cos(turn / 2), sin = std::sin(turn / 2);
  const Real w = std::sqrt(1 - 2 * kTilt * kTilt);
  const V u{kTilt * (cos + sin), kTilt * (cos - sin), w * sin};
  const Numbers start{u[0], u[1], u[2], w * cos, 0, 0, kSpin};
  const auto inWorld = [&](const V& v) {
    const V t = Real{2} * cross(u, v);
    const V turned = v + start[3] * t + cross(u, t);
    return Array3{static_cast<double>(turned[0]), static_cast<double>(turned[1]),
                  static_cast<double>(turned[2])};
  };
  const Real part = std::sqrt(dot(u, u)), angle = 2 * std::atan2(part, start[3]);
  for (std::size_t i = 0; i < 3; ++i) c.rotation[i] = static_cast<double>(angle / part * u[i]);
  const V w_P{0, 0, kSpin}, r = Rolling(c).arm(upSeenFrom(start));
  c.w_W = inWorld(w_P);
  c.v_W = inWorld(cross(r, w_P));
  c.x_W = {0, 0, -inWorld(r)[2]};
  constexpr int kRollSteps = 40000;
  const Numbers end = rolled(c, start, kRollSteps);
  c.attitude = attitude(end);
  std::printf(
      "\nrattleback that rolls: after %g s it spins at %.3f rad/s and looks %.2f rad away from its "
      "start; error %.0e rad\n",
      c.duration, static_cast<double>(end[6]), angleBetween(attitude(start), c.attitude),
      angleBetween(attitude(rolled(c, start, kRollSteps / 2)), c.attitude));
  return c;
}

}  // namespace rigid_body_sim::touch_peers
