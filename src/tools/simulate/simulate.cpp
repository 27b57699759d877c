#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

#include <rigid_body_sim/dynamics/describe_solution.hpp>
#include <rigid_body_sim/scene/build_world.hpp>

#include "programs/tool_scene.hpp"
#include "programs/usage.hpp"
#include "ros/bag/bag_inputs.hpp"
#include "ros/inputs/input_replay.hpp"
#include "tools/common/preface.hpp"
#include "tools/common/progress_bar.hpp"
#include "tools/common/state_at.hpp"
#include "tools/simulate/bag_output.hpp"
#include "tools/simulate/csv_writer.hpp"
#include "tools/simulate/run_summary.hpp"
#include "tools/simulate/simulate_options.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kBagSample = 0.01;  // [s] as the node publishes by default

Scene sceneOf(const SimulateOptions& options) {
  Scene scene = loadToolScene(options.scene);
  scene.time_step = options.time_step.value_or(scene.time_step);
  scene.tolerance = options.tolerance.value_or(scene.tolerance);
  scene.tolerance_stated |= options.tolerance.has_value();
  if (options.integrator) {
    scene.integrator = *options.integrator;
    scene.integrator_line = 0;
  }
  if (options.tolerance && scene.integrator != "auto")
    throw UsageError("--tolerance goes with integrator auto only, got integrator " +
                     scene.integrator);
  return scene;
}

std::unique_ptr<InputReplay> replayOf(const std::string& path, const Scene& scene,
                                      const World& world, Preface& preface) {
  const BagInputs recorded = readBagInputs(path, scene, world);
  if (!recorded.notice.empty()) preface.add(noticeLine("simulate", path + ": " + recorded.notice));
  return std::make_unique<InputReplay>(recorded.inputs);
}

/// Where a run goes beside the CSV, and what comes in.
struct Bags {
  std::unique_ptr<BagOutput> output;
  std::unique_ptr<InputReplay> replay;
};

/// As the node: what has come in is taken over before a step, the state is told after it.
StepHooks hooksOf(const Bags& bags, Simulation& simulation, Preface& preface) {
  StepHooks hooks;
  if (bags.replay)
    hooks.before = [&] {
      const bool moved = bags.replay->applyDue(simulation);
      if (bags.replay->isDone()) preface.say();
      if (moved && bags.output) bags.output->breakTrails();
    };
  if (bags.output) hooks.within = [&](double t) { bags.output->writeWithinStep(t); };
  if (bags.output) hooks.after = [&] { bags.output->writeDue(); };
  return hooks;
}

/// Runs to the end, a row at every sample and at the end. Returns the last state.
State simulate(Simulation& simulation, double duration, double sample, const StepHooks& hooks,
               CsvWriter* csv) {
  const World& world = simulation.world();
  // a duration that misses a multiple of the sample by rounding is one
  const double ratio = duration / sample;
  const auto samples =
      static_cast<std::int64_t>(std::max(1.0, std::ceil(ratio - std::max(1e-9, 1e-15 * ratio))));
  ProgressBar bar;
  // what came in before the first step changes the state that it begins with
  if (hooks.before) hooks.before();
  if (hooks.after) hooks.after();
  State state = simulation.state();
  if (csv) csv->write(world, state);
  for (std::int64_t k = 1; k <= samples; ++k) {
    state = stateAt(simulation, k == samples ? duration : static_cast<double>(k) * sample, hooks);
    if (csv) csv->write(world, state);
    bar.show(static_cast<double>(k) / static_cast<double>(samples));
  }
  return state;
}

void run(const SimulateOptions& options) {
  const Scene scene = sceneOf(options);
  const double duration = options.duration.value_or(scene.horizon);
  const double sample = options.sample.value_or(scene.time_step);
  requireCountable(duration, scene.time_step, "steps");
  requireCountable(duration, sample, "samples");
  const World world = buildWorld(scene);
  const State first = initialState(scene, world);
  Simulation simulation(world, first);
  std::unique_ptr<CsvWriter> csv;
  if (options.csv) {
    csv = std::make_unique<CsvWriter>(*options.csv);
    csv->finish();  // the header: a file that takes nothing is told of before the run
  }
  Preface preface;
  for (const std::string& notice : scene.notices) preface.add(noticeLine("simulate", notice));
  Bags bags;
  if (options.wrench_bag) bags.replay = replayOf(*options.wrench_bag, scene, world, preface);
  if (options.bag)
    bags.output = std::make_unique<BagOutput>(*options.bag, 1 / options.sample.value_or(kBagSample),
                                              scene, simulation);
  for (const std::string& line : describeSolution(simulation)) preface.add(line);
  if (!bags.replay) preface.say();  // else an input to come may not be of this scene

  const auto begin = std::chrono::steady_clock::now();
  State last;
  try {
    last = simulate(simulation, duration, sample, hooksOf(bags, simulation, preface), csv.get());
  } catch (const SimulationDiverged&) {
    preface.say();
    throw;
  }
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  if (csv) csv->finish();
  if (bags.output) bags.output->finish();
  const std::string parts = describeSubsteps(simulation);
  if (!parts.empty()) preface.add(noticeLine("simulate", parts));
  preface.say();

  std::FILE* out = options.csv == "-" ? stderr : stdout;
  std::fprintf(out, "%s: %.6g s in steps of %.6g s with %s, in %.3g s\n", options.scene.c_str(),
               last.t, world.solver.time_step, world.solver.integrator.c_str(), wall.count());
  std::fputs(runSummary(world, first, last).c_str(), out);
  requireWritten(out);
}

}  // namespace
}  // namespace rigid_body_sim

int main(int argc, char** argv) {
  using namespace rigid_body_sim;
  try {
    const SimulateOptions options = parseSimulateOptions(argc, argv);
    if (options.help)
      std::fputs(simulateHelp().c_str(), stdout);
    else
      run(options);
    return kDone;
  } catch (const UsageError& error) {
    std::fprintf(stderr, "simulate: %s (simulate --help)\n", error.what());
    return kWrongUsage;
  } catch (const SimulationDiverged& error) {
    std::fprintf(stderr, "simulate: %s\n", error.what());
    return kDiverged;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "simulate: %s\n", error.what());
    return kBadInput;
  }
}
