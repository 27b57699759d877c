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

Quaternion4 unit(const Quaternion4& q) {
  const double norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  return {q[0] / norm, q[1] / norm, q[2] / norm, q[3] / norm};
}

Quaternion4 attitudeOf(const State& s) { return unit({s[6], s[7], s[8], s[9]}); }

Motion motionOf(const State& s) {
  return {{s[0], s[1], s[2]}, {s[3], s[4], s[5]}, attitudeOf(s), {s[10], s[11], s[12]}};
}

/// R v, for the state's attitude.
Array3 toWorldAxes(const State& s, const Array3& v) {
  const double x = s[6], y = s[7], z = s[8], w = s[9];
  return {
      (1 - 2 * (y * y + z * z)) * v[0] + 2 * (x * y - w * z) * v[1] + 2 * (x * z + w * y) * v[2],
      2 * (x * y + w * z) * v[0] + (1 - 2 * (x * x + z * z)) * v[1] + 2 * (y * z - w * x) * v[2],
      2 * (x * z - w * y) * v[0] + 2 * (y * z + w * x) * v[1] + (1 - 2 * (x * x + y * y)) * v[2]};
}

/// Rᵀ v.
Array3 fromWorldAxes(const State& s, const Array3& v) {
  return toWorldAxes({s[0], s[1], s[2], s[3], s[4], s[5], -s[6], -s[7], -s[8], s[9]}, v);
}

enum class Load { kHeld, kSpring, kPulls };

/// Under a held force, and what else is said.
template <Load kLoad>
struct RightHandSide {
  const Problem& p;

  void operator()(const State& s, State& d, double) const {
    const double x = s[6], y = s[7], z = s[8], w = s[9];
    const double a = s[10], b = s[11], c = s[12];
    const auto& F = p.force_W;
    const auto [fx, fy, fz] = fromWorldAxes(s, F);
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
    if constexpr (kLoad == Load::kSpring) addSpring(*p.spring, s, d);
    if constexpr (kLoad == Load::kPulls)
      for (const Pull& pull : p.pulls(motionOf(s))) addPull(pull, s, d);
  }

 private:
  void addForce(const Array3& f_W, const Array3& r_P, const State& s, State& d) const {
    const auto [fx, fy, fz] = fromWorldAxes(s, f_W);
    const auto [x, y, z] = r_P;
    for (std::size_t i = 0; i < 3; ++i) d[3 + i] += f_W[i] / p.mass;
    d[10] += (y * fz - z * fy) / p.I[0];
    d[11] += (z * fx - x * fz) / p.I[1];
    d[12] += (x * fy - y * fx) / p.I[2];
  }

  void addSpring(const SpringToWorld& spring, const State& s, State& d) const {
    auto [x, y, z] = toWorldAxes(s, spring.arm_P);
    x += s[0] - spring.anchor_W[0];
    y += s[1] - spring.anchor_W[1];
    z += s[2] - spring.anchor_W[2];
    const double per_length =
        spring.stiffness * (spring.rest_length / std::sqrt(x * x + y * y + z * z) - 1);
    addForce({per_length * x, per_length * y, per_length * z}, spring.arm_P, s, d);
  }

  void addPull(const Pull& pull, const State& s, State& d) const {
    addForce(pull.force_W, pull.arm_P, s, d);
    const Array3 tau_P = fromWorldAxes(s, pull.torque_W);
    for (std::size_t i = 0; i < 3; ++i) d[10 + i] += tau_P[i] / p.I[i];
  }
};

using WheelState = std::array<double, 10>;  // q (x y z w), ω, momenta of the wheels

Quaternion4 attitudeOf(const WheelState& s) { return unit({s[0], s[1], s[2], s[3]}); }

/// From one change of the right-hand side to the next.
template <class System>
struct Stretch {
  double start, end;  ///< [s]
  System system;
};

template <class System>
using Stretches = std::vector<Stretch<System>>;

template <class Start, class Integrate>
Run timed(const std::string& setting, const Start& start, const Integrate& integrate) {
  constexpr double kBudget = 0.01;  // [s]
  Run run;
  run.setting = setting;
  run.seconds = undisturbedCpuTime(
      start,
      [&](Start& s) {
        integrate(s);
        run.q = attitudeOf(s);
      },
      kBudget);
  return run;
}

/// Each stretch in equal steps of at most h.
template <class Stepper, class System, class Start>
void addFixed(const char* name, const Stretches<System>& stretches, const Start& start,
              std::vector<Run>& runs) {
  constexpr double kLongest = 0.02;  // [s] beyond it nothing competes
  for (double steps = 32; steps < 1e6; steps = std::round(1.2 * steps)) {
    const double h = stretches.back().end / steps;
    runs.push_back(timed(label(name, "h", h), start, [&](Start& s) {
      for (const auto& [from, to, system] : stretches) {
        const double count = std::ceil((to - from) / h - 1e-6);
        odeint::integrate_n_steps(Stepper(), system, s, from, (to - from) / count,
                                  static_cast<std::size_t>(count));
      }
    }));
    if (runs.back().seconds > kLongest) break;
  }
}

template <class MakeStepper, class System, class Start>
void addControlled(const char* name, const MakeStepper& make, const Stretches<System>& stretches,
                   const Start& start, std::vector<Run>& runs) {
  for (double tolerance = 1e-2; tolerance > 1e-15; tolerance /= 2)
    runs.push_back(timed(label(name, "tolerance", tolerance), start, [&](Start& s) {
      for (const auto& [from, to, system] : stretches)
        odeint::integrate_adaptive(make(tolerance), system, s, from, to, 0.05);
    }));
}

/// Rk4, dopri5, rkf78 in fixed and controlled steps and Bulirsch–Stoer, each over a ladder.
template <class System, class Start>
std::vector<Run> runsFrom(const Start& start, const Stretches<System>& stretches) {
  using Rk4 = odeint::runge_kutta4<Start>;
  using Dopri5 = odeint::runge_kutta_dopri5<Start>;
  using Rkf78 = odeint::runge_kutta_fehlberg78<Start>;
  std::vector<Run> runs;
  addFixed<Rk4>("rk4", stretches, start, runs);
  addFixed<Dopri5>("dopri5", stretches, start, runs);
  addFixed<Rkf78>("rkf78", stretches, start, runs);
  addControlled(
      "dopri5", [](double e) { return odeint::make_controlled<Dopri5>(e, e); }, stretches, start,
      runs);
  addControlled(
      "rkf78", [](double e) { return odeint::make_controlled<Rkf78>(e, e); }, stretches, start,
      runs);
  addControlled(
      "bulirsch_stoer", [](double e) { return odeint::bulirsch_stoer<Start>(e, e); }, stretches,
      start, runs);
  return runs;
}

template <class System>
std::vector<Run> runsUnder(const Problem& problem) {
  return runsFrom(stateOf(problem.start),
                  Stretches<System>{{0, problem.duration, System{problem}}});
}

/// A free body with wheels: L = I_r ω + h, I_r = I − J.
struct WheelsTurn {
  Array3 I_r;
  Array3 torque_P;

  void operator()(const WheelState& s, WheelState& d, double) const {
    const auto [x, y, z, w, a, b, c, ha, hb, hc] = s;
    const double La = I_r[0] * a + ha, Lb = I_r[1] * b + hb, Lc = I_r[2] * c + hc;
    d[0] = 0.5 * (w * a + y * c - z * b);
    d[1] = 0.5 * (w * b + z * a - x * c);
    d[2] = 0.5 * (w * c + x * b - y * a);
    d[3] = -0.5 * (x * a + y * b + z * c);
    d[4] = (c * Lb - b * Lc - torque_P[0]) / I_r[0];
    d[5] = (a * Lc - c * La - torque_P[1]) / I_r[1];
    d[6] = (b * La - a * Lb - torque_P[2]) / I_r[2];
    for (std::size_t i = 0; i < 3; ++i) d[7 + i] = torque_P[i];
  }
};

std::vector<Run> wheelRuns(const Problem& problem, const ReactionWheels& wheels) {
  const Quaternion4& q = problem.start.q;
  const Array3& w = problem.start.w_P;
  const double J = wheels.inertia;
  const WheelState start{q[0], q[1], q[2], q[3], w[0], w[1], w[2], J * w[0], J * w[1], J * w[2]};
  const Array3 I_r{problem.I[0] - J, problem.I[1] - J, problem.I[2] - J};
  Stretches<WheelsTurn> stretches;
  for (std::size_t i = 0; i < wheels.commands.size(); ++i)
    stretches.push_back({wheels.commands[i].start,
                         wheels.endOf(i, problem.duration),
                         {I_r, wheels.commands[i].torque_P}});
  return runsFrom(start, stretches);
}

std::vector<Run> odeintRuns(const Problem& problem) {
  if (problem.wheels) return wheelRuns(problem, *problem.wheels);
  return problem.spring ? runsUnder<RightHandSide<Load::kSpring>>(problem)
                        : runsUnder<RightHandSide<Load::kHeld>>(problem);
}

Motion rk4End(const Problem& problem, double h, int steps) {
  State s = stateOf(problem.start);
  const auto integrate = [&](const auto& rhs) {
    odeint::integrate_n_steps(odeint::runge_kutta4<State>(), rhs, s, 0.0, h,
                              static_cast<std::size_t>(steps));
  };
  if (problem.pulls)
    integrate(RightHandSide<Load::kPulls>{problem});
  else
    integrate(RightHandSide<Load::kHeld>{problem});
  return motionOf(s);
}

double rk4Crowd(const std::vector<Problem>& bodies, double h, int steps) {
  std::vector<State> states;
  std::vector<RightHandSide<Load::kHeld>> right_hand_sides;
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
