#include <cmath>

#include <boost/numeric/odeint.hpp>

#include "benchmark/peers.hpp"
#include "tools/trade/cpu_time.hpp"

// What a user of odeint would write in an afternoon: position, velocity, quaternion, angular
// velocity in body axes, and a plain right-hand side.

namespace rigid_body_sim::peers {
namespace {

namespace odeint = boost::numeric::odeint;
using State = std::array<double, 13>;  // x, v, q (x y z w), ω

State stateOf(const Motion& m) {
  State s{};
  std::copy(m.x_W.begin(), m.x_W.end(), s.begin());
  std::copy(m.v_W.begin(), m.v_W.end(), s.begin() + 3);
  std::copy(m.q.begin(), m.q.end(), s.begin() + 6);
  std::copy(m.w_P.begin(), m.w_P.end(), s.begin() + 10);
  return s;
}

Motion motionOf(const State& s) {
  const double norm = std::sqrt(s[6] * s[6] + s[7] * s[7] + s[8] * s[8] + s[9] * s[9]);
  return {{s[0], s[1], s[2]},
          {s[3], s[4], s[5]},
          {s[6] / norm, s[7] / norm, s[8] / norm, s[9] / norm},
          {s[10], s[11], s[12]}};
}

/// With pulls or without.
template <bool kPulled>
struct RightHandSide {
  const Problem& p;

  void operator()(const State& s, State& d, double) const {
    const double x = s[6], y = s[7], z = s[8], w = s[9];
    const double a = s[10], b = s[11], c = s[12];
    const auto& F = p.force_W;
    const auto fromWorldAxes = [&](const Array3& v) -> Array3 {  // Rᵀ v
      return {(1 - 2 * (y * y + z * z)) * v[0] + 2 * (x * y + w * z) * v[1] +
                  2 * (x * z - w * y) * v[2],
              2 * (x * y - w * z) * v[0] + (1 - 2 * (x * x + z * z)) * v[1] +
                  2 * (y * z + w * x) * v[2],
              2 * (x * z + w * y) * v[0] + 2 * (y * z - w * x) * v[1] +
                  (1 - 2 * (x * x + y * y)) * v[2]};
    };
    const auto [fx, fy, fz] = fromWorldAxes(F);
    for (std::size_t i = 0; i < 3; ++i) {
      d[i] = s[3 + i];
      d[3 + i] = p.g_W[i] + F[i] / p.mass;
    }
    d[6] = 0.5 * (w * a + y * c - z * b);
    d[7] = 0.5 * (w * b + z * a - x * c);
    d[8] = 0.5 * (w * c + x * b - y * a);
    d[9] = -0.5 * (x * a + y * b + z * c);
    d[10] = (p.arm_P[1] * fz - p.arm_P[2] * fy - (p.I[2] - p.I[1]) * b * c) / p.I[0];
    d[11] = (p.arm_P[2] * fx - p.arm_P[0] * fz - (p.I[0] - p.I[2]) * c * a) / p.I[1];
    d[12] = (p.arm_P[0] * fy - p.arm_P[1] * fx - (p.I[1] - p.I[0]) * a * b) / p.I[2];
    if constexpr (kPulled)
      for (const Pull& pull : p.pulls(motionOf(s)))
        add(pull, fromWorldAxes(pull.force_W), fromWorldAxes(pull.torque_W), d);
  }

 private:
  /// f_P, tau_P: the pull's force and couple in body axes.
  void add(const Pull& pull, const Array3& f_P, const Array3& tau_P, State& d) const {
    const Array3& r = pull.arm_P;
    const Array3 about{r[1] * f_P[2] - r[2] * f_P[1], r[2] * f_P[0] - r[0] * f_P[2],
                       r[0] * f_P[1] - r[1] * f_P[0]};
    for (std::size_t i = 0; i < 3; ++i) {
      d[3 + i] += pull.force_W[i] / p.mass;
      d[10 + i] += (about[i] + tau_P[i]) / p.I[i];
    }
  }
};

template <class Integrate>
Run timed(const Problem& problem, const std::string& setting, const Integrate& integrate) {
  constexpr double kBudget = 0.01;  // [s]
  Run run;
  run.setting = setting;
  run.seconds = leastCpuTime(
      stateOf(problem.start),
      [&](State& s) {
        integrate(s);
        run.q = motionOf(s).q;
      },
      kBudget);
  return run;
}

template <class Stepper>
void addFixed(const char* name, const Problem& problem, std::vector<Run>& runs) {
  constexpr double kLongest = 0.02;  // [s] beyond it nothing competes
  const RightHandSide<false> rhs{problem};
  for (double steps = 32; steps < 1e6; steps = std::round(1.2 * steps)) {
    const double h = problem.duration / steps;
    runs.push_back(timed(problem, label(name, "h", h), [&](State& s) {
      odeint::integrate_n_steps(Stepper(), rhs, s, 0.0, h, static_cast<std::size_t>(steps));
    }));
    if (runs.back().seconds > kLongest) break;
  }
}

template <class MakeStepper>
void addControlled(const char* name, const Problem& problem, const MakeStepper& make,
                   std::vector<Run>& runs) {
  const RightHandSide<false> rhs{problem};
  for (double tolerance = 1e-2; tolerance > 1e-15; tolerance /= 2)
    runs.push_back(timed(problem, label(name, "tolerance", tolerance), [&](State& s) {
      odeint::integrate_adaptive(make(tolerance), rhs, s, 0.0, problem.duration, 0.05);
    }));
}

/// Rk4, dopri5, rkf78 in fixed and controlled steps and Bulirsch–Stoer, each over a ladder.
std::vector<Run> odeintRuns(const Problem& problem) {
  using Rk4 = odeint::runge_kutta4<State>;
  using Dopri5 = odeint::runge_kutta_dopri5<State>;
  using Rkf78 = odeint::runge_kutta_fehlberg78<State>;
  std::vector<Run> runs;
  addFixed<Rk4>("rk4", problem, runs);
  addFixed<Dopri5>("dopri5", problem, runs);
  addFixed<Rkf78>("rkf78", problem, runs);
  addControlled(
      "dopri5", problem, [](double e) { return odeint::make_controlled<Dopri5>(e, e); }, runs);
  addControlled(
      "rkf78", problem, [](double e) { return odeint::make_controlled<Rkf78>(e, e); }, runs);
  addControlled(
      "bulirsch_stoer", problem, [](double e) { return odeint::bulirsch_stoer<State>(e, e); },
      runs);
  return runs;
}

Motion rk4End(const Problem& problem, double h, int steps) {
  State s = stateOf(problem.start);
  const auto integrate = [&](const auto& rhs) {
    odeint::integrate_n_steps(odeint::runge_kutta4<State>(), rhs, s, 0.0, h,
                              static_cast<std::size_t>(steps));
  };
  if (problem.pulls)
    integrate(RightHandSide<true>{problem});
  else
    integrate(RightHandSide<false>{problem});
  return motionOf(s);
}

double rk4Crowd(const std::vector<Problem>& bodies, double h, int steps) {
  std::vector<State> states;
  std::vector<RightHandSide<false>> right_hand_sides;
  for (const Problem& body : bodies) {
    states.push_back(stateOf(body.start));
    right_hand_sides.push_back({body});
  }
  odeint::runge_kutta4<State> stepper;
  const double begin = cpuTime();
  for (int k = 0; k < steps; ++k)
    for (std::size_t i = 0; i < states.size(); ++i)
      stepper.do_step(right_hand_sides[i], states[i], 0.0, h);
  return cpuTime() - begin;
}

const Registration kOdeint(
    {"odeint", odeintRuns, {{"odeint rk4", rk4End}}, {{"odeint rk4", rk4Crowd}}});

}  // namespace
}  // namespace rigid_body_sim::peers
