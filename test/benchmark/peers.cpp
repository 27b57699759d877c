#include <cstdio>
#include <limits>
#include <sstream>

#include <rigid_body_sim/dynamics/rotor.hpp>
#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/dynamics/taylor_segment.hpp>

#include "benchmark/peers_odeint.hpp"
#include "tools/cpu_time.hpp"

// Processor time to reach an attitude error, for three cases: the best of odeint against every row
// of the catalogue and auto, in one run on one machine. odeint is compiled for this very processor,
// ours as it is shipped.
//   A  a free body, 100 s
//   B  the same, spun about its unstable axis, 60 s
//   C  a box under gravity and a constant world force at a body point, 10 s

namespace rigid_body_sim::peers {
namespace {

Vector3d vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

Body bodyOf(const Problem& p) {
  const Vector3d I = vector(p.I);
  return makeBody(p.name, {p.mass, Vector3d::Zero(), I.asDiagonal()});
}

/// The problem's axes need not ascend; P is the body's own sorted frame.
BodyState startOf(const Problem& p, const Body& body) {
  BodyFrameMotion motion;
  motion.w_W = vector(p.w);
  return toBodyState(body, motion);
}

PointWrench pushOf(const Problem& p, const Body& body) {
  PointWrench push;
  push.force = vector(p.force_W);
  push.point = body.X_BP.inverse() * vector(p.arm_P);
  return push;
}

World worldOf(const Problem& p, const std::string& integrator, double time_step, double tolerance) {
  World world;
  world.bodies = {bodyOf(p)};
  world.g_W = vector(p.g_W);
  const PointWrench push = pushOf(p, world.bodies[0]);
  if (!push.force.isZero(0)) world.wrenches = {push};
  world.solver.integrator = integrator;
  world.solver.time_step = time_step;
  world.solver.horizon = p.duration;
  world.solver.tolerance_stated = tolerance > 0;
  if (tolerance > 0) world.solver.tolerance = tolerance;
  return world;
}

/// The attitude of the body frame at the end, by the exact rotation or Taylor series, in long
/// double.
Quaternion<long double> truth(const Problem& p) {
  const Body body = bodyOf(p);
  const BodyState start = startOf(p, body);
  BodyStateT<long double> s;
  s.q_WP = start.q_WP.cast<long double>().normalized();
  s.p_W.setZero();
  s.L_P = start.L_P.cast<long double>();
  s.L_W = rotate(s.q_WP, s.L_P);
  const Quaternion<long double> q_PB = body.q_BP.cast<long double>().conjugate();
  if (vector(p.force_W).isZero(0)) {
    const Rotor<long double> rotor(body.I.cast<long double>());
    return rotor.from(s.q_WP, s.L_P, s.L_W).at(p.duration).q_WP * q_PB;
  }
  HeldWrench held;
  held.add(pushOf(p, body));
  return advanceTaylor<long double>(body, held, vector(p.g_W), s, p.duration).q_WP * q_PB;
}

double angleTo(const Quaternion<long double>& q, const std::array<double, 4>& c) {
  const Quaternion<long double> other(c[3], c[0], c[1], c[2]);
  const Quaternion<long double> d = q.conjugate() * other;
  return static_cast<double>(2 * std::atan2(d.vec().norm(), std::abs(d.w())));
}

/// tolerance: for auto; 0: none, what can be solved is solved to rounding.
Run ourRun(const Problem& p, const std::string& integrator, int steps, double tolerance = 0) {
  constexpr double kBudget = 0.03;  // [s]
  const World world = worldOf(p, integrator, p.duration / steps, tolerance);
  State initial;
  initial.bodies = {startOf(p, world.bodies[0])};
  Run run;
  std::ostringstream setting;
  setting << integrator << ' ' << steps << " steps";
  if (tolerance > 0) setting << ", tolerance " << tolerance;
  run.setting = setting.str();
  run.seconds = leastCpuTime(
      Simulation(world, initial),
      [&](Simulation& simulation) {
        while (simulation.steps() < steps) simulation.step();
        const Quaterniond q = simulation.state().bodies[0].q_WP * world.bodies[0].q_BP.conjugate();
        run.q = {q.x(), q.y(), q.z(), q.w()};
      },
      kBudget);
  return run;
}

std::vector<Run> ourRuns(const Problem& p, const std::string& integrator) {
  constexpr double kLongest = 0.02;  // [s] as for odeint
  constexpr int kCoarse = 1000;  // steps so long are divided, and may cost more than shorter ones
  std::vector<Run> runs;
  if (integrator == "auto") {  // its error does not depend on the step
    runs.push_back(ourRun(p, integrator, 1));
    for (double tolerance = 1e-12; tolerance < 1; tolerance *= 2)
      runs.push_back(ourRun(p, integrator, 1, tolerance));
    return runs;
  }
  for (int steps = 1; steps < 1000000; steps = steps + 1 + steps / 5) {
    try {
      runs.push_back(ourRun(p, integrator, steps));
    } catch (const SimulationDiverged&) {
      continue;
    }
    if (runs.back().seconds > kLongest && steps > kCoarse) break;
  }
  return runs;
}

const Run* cheapest(const std::vector<Run>& runs, const Quaternion<long double>& q, double error) {
  const Run* best = nullptr;
  for (const Run& run : runs)
    if (angleTo(q, run.q) <= error && (!best || run.seconds < best->seconds)) best = &run;
  return best;
}

void compare(const Problem& p) {
  const Quaternion<long double> q = truth(p);
  const std::vector<Run> odeint = odeintRuns(p);
  std::vector<std::pair<std::string, std::vector<Run>>> ours{{"auto", ourRuns(p, "auto")}};
  for (const Method& row : catalogue()) ours.emplace_back(row.name, ourRuns(p, row.name));

  std::printf("\ncase %s: processor time [us], and how many times faster than odeint\n", p.name);
  std::printf("%-20s", "attitude error [rad]");
  constexpr double kTargets[] = {1e-2, 1e-4, 1e-6, 1e-9, 1e-11};
  for (double target : kTargets) std::printf(" %18.0e", target);
  std::printf("\n%-20s", "odeint");
  for (double target : kTargets) {
    const Run* run = cheapest(odeint, q, target);
    if (run) std::printf(" %18.1f", 1e6 * run->seconds);
    if (!run) std::printf(" %18s", "not reached");
  }
  for (const auto& row : ours) {
    std::printf("\n%-20s", row.first.c_str());
    for (double target : kTargets) {
      const Run* run = cheapest(row.second, q, target);
      const Run* peer = cheapest(odeint, q, target);
      if (run && peer)
        std::printf(" %9.1f (%6.3g)", 1e6 * run->seconds, peer->seconds / run->seconds);
      else if (run)
        std::printf(" %9.1f (%6s)", 1e6 * run->seconds, "-");
      else
        std::printf(" %18s", "not reached");
    }
  }
  std::printf("\nthe best of odeint:");
  for (double target : kTargets)
    if (const Run* run = cheapest(odeint, q, target))
      std::printf(" %.0e %s;", target, run->setting.c_str());
  std::printf("\nauto with no tolerance stated: %.1e rad in %.1f us\n",
              angleTo(q, ours[0].second[0].q), 1e6 * ours[0].second[0].seconds);
  for (double tolerance : kTargets) {
    const Run run = ourRun(p, "auto", 1, tolerance);
    std::printf("auto with tolerance %.0e: %.1e rad in %.1f us\n", tolerance, angleTo(q, run.q),
                1e6 * run.seconds);
  }
}

}  // namespace
}  // namespace rigid_body_sim::peers

int main() {
  using namespace rigid_body_sim::peers;
  const double Ix = 2. / 12 * (0.25 + 0.0625), Iy = 2. / 12 * (1 + 0.0625), Iz = 2. / 12 * 1.25;
  compare({"A", 1, {1, 2, 3}, {0.5, 2, 0.3}, {}, {}, {}, 100});
  compare({"B", 1, {1, 2, 3}, {1e-4, 5, 1e-4}, {}, {}, {}, 60});
  compare({"C", 2, {Ix, Iy, Iz}, {}, {0, 0, -9.81}, {1, 2, 12}, {0.3, -0.1, 0.05}, 10});
}
