#include "tools/trade/trade_setting.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "dynamics/methods/catalogue.hpp"
#include "tools/common/state_at.hpp"
#include "tools/trade/cpu_time.hpp"

namespace rigid_body_sim {
namespace {

/// See Setting::work.
double countedWork(const Simulation& simulation) {
  double work = 0;
  for (const MotionPlan& plan : simulation.plans()) {
    if (plan.integrator.empty()) continue;
    const Method& method = methodNamed(plan.integrator);
    work += method.cost * static_cast<double>(plan.evaluations) / method.evaluations *
            static_cast<double>(plan.bodies.size());
  }
  return work;
}

/// At an instant of the reference. Where steps are longer than all of it together, an instant may
/// be nearer to one of their ends than what stateAt takes for rounding, and is not there all the
/// same.
State stateOf(Simulation& simulation, const Reference& reference, std::size_t instant) {
  const auto instants = static_cast<double>(reference.states.size() - 1);
  const double t = reference.duration * static_cast<double>(instant) / instants;
  const double rounding = 1e-9 * reference.duration / instants;
  stepTo(simulation, t);
  return std::abs(t - simulation.time()) <= rounding ? simulation.state() : simulation.sample(t);
}

}  // namespace

double movingBodyCount(const World& world) {
  return static_cast<double>(std::count_if(world.bodies.begin(), world.bodies.end(),
                                           [](const Body& body) { return moves(body); }));
}

Setting measureSetting(const World& world, const Reference& reference,
                       const std::string& integrator, double time_step, const Patience& patience) {
  World copy = world;
  copy.solver.integrator = integrator;
  copy.solver.time_step = time_step;
  const Simulation start(std::move(copy), reference.states.front());

  Setting setting;
  setting.integrator = integrator;
  setting.time_step = time_step;
  Simulation sampled(start);
  std::vector<State> track{start.state()};
  const std::size_t instants = reference.states.size() - 1;
  for (std::size_t k = 1; k <= instants; ++k) track.push_back(stateOf(sampled, reference, k));
  setting.errors = errorsOf(world, track, reference.states);
  setting.has_substeps = sampled.maxSubsteps() > 1;

  const double whole_steps = std::ceil(reference.duration / time_step - 1e-6);
  const auto steps = static_cast<std::int64_t>(std::max(1.0, whole_steps));
  const auto run = [&](Simulation& simulation) {
    while (simulation.steps() < steps) {
      simulation.step();
      // what a step is taken for; a solved motion is evaluated here
      for (std::size_t i = 0; i < world.bodies.size(); ++i) simulation.body(i);
    }
    setting.force_evaluations = simulation.evaluations();
    setting.work = countedWork(simulation);
  };
  setting.cpu_ns_per_sim_s = 1e9 * undisturbedCpuTime(start, run, patience.timing) /
                             (static_cast<double>(steps) * time_step);
  return setting;
}

std::optional<Setting> tryMeasuring(const World& world, const Reference& reference,
                                    const std::string& integrator, double time_step,
                                    const Patience& patience) {
  try {
    return measureSetting(world, reference, integrator, time_step, patience);
  } catch (const SimulationDiverged&) {
    return std::nullopt;
  }
}

double resolvedError(const Setting& setting, const Reference& reference) {
  return std::max(setting.errors.bounded(), reference.doubt.bounded());
}

bool canBeDrawn(const Setting& setting) {
  const double cost = setting.cpu_ns_per_sim_s;
  return cost > 0 && std::isfinite(cost) && std::isfinite(setting.errors.bounded());
}

std::string pictureFault(const std::vector<Setting>& settings) {
  if (std::any_of(settings.begin(), settings.end(), canBeDrawn)) return "";
  const bool lacks_times = std::none_of(settings.begin(), settings.end(), [](const Setting& s) {
    return s.cpu_ns_per_sim_s > 0 && std::isfinite(s.cpu_ns_per_sim_s);
  });
  return lacks_times ? "the clock of processor time is too coarse for runs as short as these"
                     : "no setting has an error that is finite";
}

std::vector<Setting> paretoFront(std::vector<Setting> settings, const Reference& reference) {
  std::sort(settings.begin(), settings.end(), [](const Setting& a, const Setting& b) {
    return a.cpu_ns_per_sim_s < b.cpu_ns_per_sim_s;
  });
  std::vector<Setting> front;
  double least = std::numeric_limits<double>::infinity();
  for (const Setting& setting : settings) {
    if (resolvedError(setting, reference) >= least) continue;
    least = resolvedError(setting, reference);
    front.push_back(setting);
  }
  return front;
}

const Setting* cheapestWithin(const std::vector<Setting>& settings, const Reference& reference,
                              double error_budget, const SolverOptions& scene) {
  // the less, the better
  const auto rank = [&](const Setting& s) {
    return std::make_tuple(s.work, s.integrator != scene.integrator, s.time_step != scene.time_step,
                           s.time_step);
  };
  const Setting* best = nullptr;
  for (const Setting& setting : settings) {
    const bool within = setting.errors.attitude + reference.doubt.attitude <= error_budget &&
                        setting.errors.position + reference.doubt.position <= error_budget;
    if (within && (!best || rank(setting) < rank(*best))) best = &setting;
  }
  return best;
}

}  // namespace rigid_body_sim
