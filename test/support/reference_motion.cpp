#include "support/reference_motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <utility>

namespace rigid_body_sim::reference {

namespace {

Motion sum(const Motion& a, Real h, const Motion& b) {
  Motion m;
  m.x = a.x + h * b.x;
  m.v = a.v + h * b.v;
  m.q.coeffs() = a.q.coeffs() + h * b.q.coeffs();
  m.w = a.w + h * b.w;
  return m;
}

Motions sum(const Motions& a, Real h, const Motions& b) {
  Motions result(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) result[i] = sum(a[i], h, b[i]);
  return result;
}

/// x' = v,  m v' = f,  q' = q (0, ω)/2,  I ω' = τ − ω × I ω, the last with differences of moments:
/// products I ω would cancel, and cost a needle the digits of its spin.
Motions rate(const std::vector<Body>& bodies, const Wrenches& wrenches, Real t,
             const Motions& motions) {
  const Loads loads = wrenches(t, motions);
  Motions rates(motions.size());
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const Motion& m = motions[i];
    const Vector I = bodies[i].I.cast<Real>();
    const Vector torque = loads[i].tau_P + m.R().transpose() * loads[i].tau_W;
    rates[i].x = m.v;
    rates[i].v = loads[i].f_W / Real(bodies[i].mass);
    rates[i].q.coeffs() = (m.q * Quaternion<Real>(0, m.w.x(), m.w.y(), m.w.z())).coeffs() / 2;
    const Vector gyroscopic((I[2] - I[1]) * m.w[1] * m.w[2], (I[0] - I[2]) * m.w[2] * m.w[0],
                            (I[1] - I[0]) * m.w[0] * m.w[1]);
    rates[i].w = (torque - gyroscopic).cwiseQuotient(I);
  }
  return rates;
}

/// The greatest difference of two motions, each quantity against its own size.
Real difference(const Motions& a, const Motions& b) {
  const auto relative = [](const Vector& x, const Vector& y) {
    const Real size = y.norm();
    return size > 0 ? (x - y).norm() / size : (x - y).norm();
  };
  Real worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    worst = std::max(worst, (a[i].q.coeffs() - b[i].q.coeffs()).norm());
    worst = std::max(worst, relative(a[i].w, b[i].w));
    worst = std::max(worst, relative(a[i].v, b[i].v));
    worst = std::max(worst, relative(a[i].x, b[i].x));
  }
  return worst;
}

/// Gragg's modified midpoint rule over h in n steps, n even; its error is a series in (h/n)².
Motions midpoint(const std::vector<Body>& bodies, const Wrenches& wrenches, Real t, Real h, int n,
                 const Motions& start, const Motions& start_rate) {
  const Real step = h / static_cast<Real>(n);
  Motions before = start;
  Motions now = sum(start, step, start_rate);
  for (int i = 1; i < n; ++i) {
    Motions next =
        sum(before, 2 * step, rate(bodies, wrenches, t + static_cast<Real>(i) * step, now));
    before = std::move(now);
    now = std::move(next);
  }
  const Motions end = sum(before, step, rate(bodies, wrenches, t + h, now));
  Motions result(start.size());
  for (std::size_t i = 0; i < start.size(); ++i) result[i] = sum(Motion(now[i]), 1, end[i]);
  for (Motion& m : result) {
    m.x /= 2;
    m.v /= 2;
    m.w /= 2;
    m.q.coeffs() /= 2;
  }
  return result;
}

}  // namespace

Matrix Motion::R() const { return q.normalized().toRotationMatrix(); }

Motion toMotion(const Body& body, const BodyState& state) {
  Motion m;
  m.x = state.x_W.cast<Real>() + state.x_low_W.cast<Real>();
  m.v = state.p_W.cast<Real>() / Real(body.mass);
  m.q = state.q_WP.cast<Real>().normalized();
  m.w = state.L_P.cast<Real>().cwiseQuotient(body.I.cast<Real>());
  return m;
}

Motions advance(const std::vector<Body>& bodies, const Wrenches& wrenches, Motions motions, Real t,
                Real duration, Real first_step, Real tolerance) {
  constexpr int kColumns = 10;
  Real h = std::min(first_step, duration);
  for (Real done = 0; done < duration;) {
    if (!(h > duration * 1e-15L)) throw std::runtime_error("reference motion: no step converges");
    h = std::min(h, duration - done);
    const Motions start_rate = rate(bodies, wrenches, t + done, motions);
    std::array<Motions, kColumns> table;  // the last row of the Aitken-Neville scheme
    Real error = 1, previous_error = 1;
    const auto converged = [&] {
      return error <= tolerance || (error < 1e-12L && error > previous_error / 2);
    };
    int row = 0;
    for (; row < kColumns && !converged(); ++row) {
      Motions entry = midpoint(bodies, wrenches, t + done, h, 2 * (row + 1), motions, start_rate);
      for (int k = 0; k < row; ++k) {
        const Real ratio = static_cast<Real>(row + 1) / static_cast<Real>(row - k);
        const Motions gain = sum(entry, -1, table[static_cast<std::size_t>(k)]);
        table[static_cast<std::size_t>(k)] = entry;
        entry = sum(entry, 1 / (ratio * ratio - 1), gain);
      }
      previous_error = error;
      if (row > 0) error = difference(entry, table[static_cast<std::size_t>(row - 1)]);
      table[static_cast<std::size_t>(row)] = std::move(entry);
    }
    if (!converged()) {
      h /= 2;
      continue;
    }
    motions = table[static_cast<std::size_t>(row - 1)];
    for (Motion& m : motions) m.q.normalize();
    done += h;
    if (row < kColumns - 1) h *= 1.5L;
  }
  return motions;
}

Motion advance(const Body& body, const std::function<Load(Real t, const Motion&)>& wrench,
               const Motion& motion, Real t, Real duration, Real first_step, Real tolerance) {
  const auto wrenches = [&](Real time, const Motions& m) { return Loads{wrench(time, m[0])}; };
  return advance(std::vector<Body>{body}, wrenches, Motions{motion}, t, duration, first_step,
                 tolerance)[0];
}

Real attitudeError(const Quaterniond& q, const Motion& m) {
  const Quaternion<Real> d = q.cast<Real>().normalized().conjugate() * m.q;
  return 2 * std::atan2(d.vec().norm(), std::abs(d.w()));
}

}  // namespace rigid_body_sim::reference
