#include "benchmark/peers_truth.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "benchmark/peers_wide.hpp"

namespace rigid_body_sim::peers {
namespace {

using namespace wide;
using Numbers = std::array<Real, 18>;  // place, momentum, body axes e₁ e₂ e₃ and L in the world

V wide3(const Array3& v) { return {v[0], v[1], v[2]}; }
V part(const Numbers& y, std::size_t at) { return {y[at], y[at + 1], y[at + 2]}; }
V axis(const Numbers& y, std::size_t i) { return part(y, 6 + 3 * i); }

Numbers numbers(const std::array<V, 6>& parts) {
  Numbers y{};
  for (std::size_t i = 0; i < y.size(); ++i) y[i] = parts[i / 3][i % 3];
  return y;
}

/// a e₁ + b e₂ + c e₃
V fromBody(const Numbers& y, const V& v) {
  return v[0] * axis(y, 0) + v[1] * axis(y, 1) + v[2] * axis(y, 2);
}

/// With the body's axes e, which turn by e' = ω × e, and ω = Σ e (e·L)/I; with wheels,
/// ω = Σ e (e·L − h)/(I − J), h' = u.
class AxesInWorld {
 public:
  explicit AxesInWorld(const Problem& p) : p_(p) {}

  Numbers start() const {
    const Motion& m = p_.start;
    Numbers y = numbers({wide3(m.x_W), Real{p_.mass} * wide3(m.v_W), turned(m.q, {1, 0, 0}),
                         turned(m.q, {0, 1, 0}), turned(m.q, {0, 0, 1}), V{}});
    const V L_W =
        fromBody(y, {p_.I[0] * Real{m.w_P[0]}, p_.I[1] * Real{m.w_P[1]}, p_.I[2] * Real{m.w_P[2]}});
    std::copy(L_W.begin(), L_W.end(), y.begin() + 15);
    return y;
  }

  /// h: of the wheels.
  Numbers rate(const Numbers& y, const V& h) const {
    const V arm = p_.spring ? fromBody(y, wide3(p_.spring->arm_P)) : V{};
    const V pull = p_.spring ? pullAt(part(y, 0) + arm) : V{};
    const V w = turning(y, h);
    return numbers({(1 / Real{p_.mass}) * part(y, 3), pull + Real{p_.mass} * wide3(p_.g_W),
                    cross(w, axis(y, 0)), cross(w, axis(y, 1)), cross(w, axis(y, 2)),
                    cross(arm, pull)});
  }

 private:
  static V turned(const Quaternion4& q, const V& v) {
    const V u{q[0], q[1], q[2]};
    return v + 2 / (dot(u, u) + Real{q[3]} * q[3]) * (q[3] * cross(u, v) + cross(u, cross(u, v)));
  }

  V pullAt(const V& end) const {
    const V along = end - wide3(p_.spring->anchor_W);
    const Real stretch = norm(along) - p_.spring->rest_length;
    return (-p_.spring->stiffness * stretch / norm(along)) * along;
  }

  V turning(const Numbers& y, const V& h) const {
    const Real J = p_.wheels ? p_.wheels->inertia : 0;
    V w{};
    for (std::size_t i = 0; i < 3; ++i)
      w[i] = (dot(axis(y, i), part(y, 15)) - h[i]) / (p_.I[i] - J);
    return fromBody(y, w);
  }

  const Problem& p_;
};

/// By the greatest of its components.
Quaternion4 attitude(const Numbers& y) {
  const V x = axis(y, 0), e = axis(y, 1), z = axis(y, 2);
  const std::array<std::array<Real, 4>, 4> products{
      {// 4 q qᵀ
       {1 + x[0] - e[1] - z[2], x[1] + e[0], x[2] + z[0], e[2] - z[1]},
       {x[1] + e[0], 1 - x[0] + e[1] - z[2], e[2] + z[1], z[0] - x[2]},
       {x[2] + z[0], e[2] + z[1], 1 - x[0] - e[1] + z[2], x[1] - e[0]},
       {e[2] - z[1], z[0] - x[2], x[1] - e[0], 1 + x[0] + e[1] + z[2]}}};
  std::size_t best = 0;
  for (std::size_t i = 1; i < 4; ++i)
    if (products[i][i] > products[best][best]) best = i;
  Quaternion4 q{};
  for (std::size_t i = 0; i < 4; ++i)
    q[i] = static_cast<double>(products[best][i] / (2 * std::sqrt(products[best][best])));
  return q;
}

/// Its wheels' momenta grow from those that they have as they stand still in the body.
Numbers endWithWheels(const Problem& p, const ReactionWheels& wheels, int steps) {
  const AxesInWorld axes(p);
  Numbers y = axes.start();
  V h = Real{wheels.inertia} * wide3(p.start.w_P);
  for (std::size_t i = 0; i < wheels.commands.size(); ++i) {
    const Real start = wheels.commands[i].start, lasts = wheels.endOf(i, p.duration) - start;
    const V u = wide3(wheels.commands[i].torque_P);
    const int count = static_cast<int>(std::ceil(steps * lasts / p.duration));
    y = advanced(y, 0, lasts / count, count,
                 [&](Real t, const Numbers& now) { return axes.rate(now, h + t * u); });
    h = h + lasts * u;
  }
  return y;
}

Quaternion4 endIn(const Problem& p, int steps) {
  if (p.wheels) return attitude(endWithWheels(p, *p.wheels, steps));
  const AxesInWorld axes(p);
  return attitude(advanced(axes.start(), 0, Real{p.duration} / steps, steps,
                           [&](Real, const Numbers& y) { return axes.rate(y, {}); }));
}

}  // namespace

Quaternion4 truthApart(const Problem& problem) {
  constexpr int kSteps = 100000;
  constexpr double kRounding = 1e-15;  // [rad] of its components in double
  const Quaternion4 end = endIn(problem, kSteps);
  Problem halved = problem;
  halved.truth = endIn(problem, kSteps / 2);
  std::printf("\ncase %s: error of the truth at most %.0e rad\n", problem.name,
              std::max(kRounding, errorOf({"", 0, end}, halved)));
  return end;
}

}  // namespace rigid_body_sim::peers
