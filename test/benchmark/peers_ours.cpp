#include "benchmark/peers_ours.hpp"

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/dynamics/spring.hpp>

#include "dynamics/methods/catalogue.hpp"
#include "dynamics/rotation/free_top.hpp"
#include "dynamics/taylor/taylor_segment.hpp"
#include "tools/trade/cpu_time.hpp"

namespace rigid_body_sim::peers {
namespace {

Vector3d vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

/// About the axes x, y, z.
std::vector<Actuator> actuatorsOf(const ReactionWheels& wheels) {
  std::vector<Actuator> actuators;
  for (const Eigen::Index k : {0, 1, 2})
    actuators.push_back({std::string(1, "xyz"[k]), Wheel{Vector3d::Unit(k), wheels.inertia, 0}});
  return actuators;
}

std::vector<ActuatorCommand> commandsOf(const ReactionWheels& wheels) {
  std::vector<ActuatorCommand> commands;
  for (const ReactionWheels::Command& command : wheels.commands)
    for (std::size_t k = 0; k < 3; ++k)
      commands.push_back({0, k, command.torque_P[k], command.start});
  return commands;
}

Body bodyOf(const Problem& p) {
  const Vector3d I = vector(p.I);
  return makeBody(p.name, {p.mass, Vector3d::Zero(), I.asDiagonal()},
                  p.wheels ? actuatorsOf(*p.wheels) : std::vector<Actuator>());
}

/// The problem's axes need not ascend; P is the body's own sorted frame.
BodyState startOf(const Problem& p, const Body& body) {
  BodyFrameMotion motion;
  motion.x_W = vector(p.start.x_W);
  motion.v_W = vector(p.start.v_W);
  motion.q_WB = Quaterniond(p.start.q.data());  // x y z w, as Eigen keeps them
  motion.w_W = motion.q_WB * vector(p.start.w_P);
  return toBodyState(body, motion);
}

/// From a point of the problem's axes to the body's principal ones, which are sorted.
Vector3d inSortedAxes(const Body& body, const Array3& point_P) {
  return body.X_BP.inverse() * vector(point_P);
}

PointWrench pushOf(const Problem& p, const Body& body) {
  PointWrench push;
  push.force = vector(p.force_W);
  push.point = inSortedAxes(body, p.arm_P);
  return push;
}

std::shared_ptr<const ForceLaw> lawOf(const SpringToWorld& spring, const Body& body) {
  return std::make_shared<Spring>(Spring::End{kWorld, vector(spring.anchor_W)},
                                  Spring::End{0, inSortedAxes(body, spring.arm_P)},
                                  Spring::Constants{spring.stiffness, 0, spring.rest_length});
}

World worldOf(const Problem& p, const std::string& integrator, double time_step) {
  World world;
  world.bodies = {bodyOf(p)};
  world.g_W = vector(p.g_W);
  if (p.isPushed()) world.wrenches = {pushOf(p, world.bodies[0])};
  if (p.wheels) world.commands = commandsOf(*p.wheels);
  if (p.spring) world.laws = {lawOf(*p.spring, world.bodies[0])};
  world.solver.integrator = integrator;
  world.solver.time_step = time_step;
  return world;
}

/// The attitude of the body frame at the end, by the exact rotation or Taylor series, in long
/// double.
Quaternion<long double> trueAttitude(const Problem& p) {
  const Body body = bodyOf(p);
  const BodyState start = startOf(p, body);
  BodyStateT<long double> s;
  s.q_WP = start.q_WP.cast<long double>().normalized();
  s.p_W.setZero();
  s.L_P = start.L_P.cast<long double>();
  s.L_W = rotate(s.q_WP, s.L_P);
  const Quaternion<long double> q_PB = body.q_BP.cast<long double>().conjugate();
  if (!p.isPushed()) {
    const FreeTop<long double> top(body.I.cast<long double>());
    return top.from(s.q_WP, s.L_P, s.L_W).at(p.duration).q_WP * q_PB;
  }
  HeldWrenchSum held;
  held.add(pushOf(p, body));
  return advanceTaylor<long double>(body, held.sum(), vector(p.g_W), s, p.duration).q_WP * q_PB;
}

Run ourRun(const Problem& p, const std::string& setting, const World& world) {
  constexpr double kBudget = 0.01;  // [s]
  State initial;
  initial.bodies = {startOf(p, world.bodies[0])};
  Run run;
  run.setting = setting;
  run.seconds = undisturbedCpuTime(
      Simulation(world, initial),
      [&](Simulation& simulation) {
        // half a step beyond any rounding of the count
        while (simulation.time() < p.duration - 0.5 * world.solver.time_step) simulation.step();
        const Quaterniond q = simulation.body(0).q_WP * world.bodies[0].q_BP.conjugate();
        run.q = {q.x(), q.y(), q.z(), q.w()};
      },
      kBudget);
  return run;
}

/// In one step, as the error does not depend on it.
World autoWorld(const Problem& p) {
  World world = worldOf(p, "auto", p.duration);
  world.solver.horizon = p.duration;
  world.solver.tolerance_stated = true;
  return world;
}

/// To rounding, and over a ladder of tolerances.
std::vector<Run> autoRuns(const Problem& p) {
  World world = autoWorld(p);
  world.solver.tolerance_stated = false;
  std::vector<Run> runs{ourRun(p, "auto", world)};
  world.solver.tolerance_stated = true;
  for (double tolerance = 1e-12; tolerance < 1; tolerance *= 1.2) {
    world.solver.tolerance = tolerance;
    runs.push_back(ourRun(p, label("auto", "tolerance", tolerance), world));
  }
  return runs;
}

std::vector<Run> runsBy(const Problem& p, const std::string& integrator) {
  constexpr double kLongest = 0.02;  // [s] as for odeint
  constexpr int kCoarse = 1000;  // steps so long are divided, and may cost more than shorter ones
  std::vector<Run> runs;
  for (int steps = 1; steps < 1000000; steps = steps + 1 + steps / 5) {
    try {
      const double h = p.duration / steps;
      runs.push_back(ourRun(p, label(integrator, "h", h), worldOf(p, integrator, h)));
    } catch (const SimulationDiverged&) {
      continue;
    }
    if (runs.back().seconds > kLongest && steps > kCoarse) break;
  }
  return runs;
}

}  // namespace

Quaternion4 truthOf(const Problem& problem) {
  const Quaterniond q = trueAttitude(problem).cast<double>();
  return {q.x(), q.y(), q.z(), q.w()};
}

std::vector<Contender> ourRuns(const Problem& problem) {
  std::vector<Contender> ours{{"auto", autoRuns(problem)}};
  for (const Method& method : catalogue()) try {
      ours.push_back({method.name, runsBy(problem, method.name)});
    } catch (const std::invalid_argument&) {
      continue;  // it does not support what acts
    }
  return ours;
}

double timeToChoose(const Problem& problem) {
  constexpr double kBudget = 0.1;  // [s]
  World world = autoWorld(problem);
  world.solver.tolerance = 1e-6;
  State initial;
  initial.bodies = {startOf(problem, world.bodies[0])};
  return undisturbedCpuTime(
      0, [&](int) { Simulation(world, initial); }, kBudget);
}

double ourCrowd(const std::vector<Problem>& bodies, const std::string& integrator, double h,
                int steps) {
  constexpr int kReadEach = 10;
  World world = worldOf(bodies.front(), integrator, h);
  world.bodies.clear();
  State initial;
  for (const Problem& problem : bodies) {
    world.bodies.push_back(bodyOf(problem));
    initial.bodies.push_back(startOf(problem, world.bodies.back()));
  }
  Simulation simulation(std::move(world), std::move(initial));
  std::vector<BodyState> states;
  simulation.step();
  const double begin = cpuTime();
  for (int k = 0; k < steps; k += kReadEach) {
    simulation.step(kReadEach);
    simulation.readBodies(states);
  }
  return cpuTime() - begin;
}

Quaternion4 ourEnd(const Problem& problem, const std::string& integrator, double h, int steps) {
  State initial;
  World world = worldOf(problem, integrator, h);
  const Body body = world.bodies[0];
  initial.bodies = {startOf(problem, body)};
  Simulation simulation(std::move(world), std::move(initial));
  simulation.step(steps);
  const Quaterniond q = simulation.body(0).q_WP * body.q_BP.conjugate();
  return {q.x(), q.y(), q.z(), q.w()};
}

}  // namespace rigid_body_sim::peers
