#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/contact_point.hpp>
#include <rigid_body_sim/dynamics/describe_solution.hpp>
#include <rigid_body_sim/dynamics/step_sampler.hpp>
#include <rigid_body_sim/scene/state_file.hpp>

#include "math/shortest.hpp"
#include "programs/formatted.hpp"
#include "programs/run_program.hpp"
#include "programs/standard_streams.hpp"
#include "programs/step_watch.hpp"
#include "programs/tool_scene.hpp"
#include "programs/usage.hpp"
#include "scene/message_text.hpp"
#include "tools/common/gnuplot.hpp"
#include "tools/common/progress_bar.hpp"
#include "tools/common/slow_run_notice.hpp"
#include "tools/common/state_at.hpp"
#include "tools/plot/plot_run.hpp"
#include "tools/simulate/run_summary.hpp"
#include "tools/simulate/simulate_job.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kBarStretches = 200;  // of a run that writes no rows

/// The steps up to the next at which an input comes, something is written or the clock is read.
std::int64_t freeSteps(const SimulateJob& job, const SlowRunNotice& slow) {
  double written = std::numeric_limits<double>::infinity();  // [s]
  if (job.imu_csv) written = std::min(written, job.imu_csv->next());
  if (job.bag) written = std::min(written, job.bag->nextInstant());
  std::int64_t until = std::min(slow.nextLook(), stepsBy(job.simulation, written));
  if (job.record) until = std::min(until, job.record->nextStep());
  return until - job.simulation.steps();
}

/// As the node: inputs are applied before a step, the state is published after it.
StepHooks hooksOf(SimulateJob& job, SlowRunNotice& slow, StepWatch& watch) {
  StepHooks hooks;
  hooks.before = [&job, &watch] { watch.begin(job.simulation.time()); };
  if (job.record)
    hooks.before = [&job, &watch] {
      watch.begin(job.simulation.time());
      const bool moved = job.record->replay().applyDue(job.simulation);
      if (job.record->replay().isDone()) job.messages.print();
      if (moved && job.bag) job.bag->breakTrails();
      if (job.bag) job.bag->followBodies();
    };
  if (job.bag || job.imu_csv)
    hooks.within = [&job](double t) {
      if (job.imu_csv) job.imu_csv->writeWithinStep(t);
      if (job.bag) job.bag->writeWithinStep(t);
    };
  hooks.after = [&job, &slow] {
    if (job.imu_csv) job.imu_csv->writeDue();
    if (job.bag) job.bag->writeDue();
    const std::string text = slow.textIfDue(job.simulation);
    if (text.empty()) return;
    job.note(text);
    job.messages.print();  // though an input to come may be at fault: the user waits now
  };
  hooks.sample = [&job, states = std::make_shared<StatesWithin>()](double t) {
    return states->at(job.simulation, t);
  };
  hooks.free_steps = [&job, &slow] { return freeSteps(job, slow); };
  return hooks;
}

void writeRow(const State& state, SimulateJob& job) {
  if (job.csv) job.csv->write(job.simulation.world(), state);
  if (job.plot) job.plot->write(state);
}

void describe(SimulateJob& job) {
  for (const std::string& line : describeSolution(job.simulation)) job.messages.add(line);
  // else an input to come may not be of this scene
  if (!job.record || job.record->replay().isDone()) job.messages.print();
}

/// Runs to the end, a row at every sample and at the end. Returns the last state.
State simulate(SimulateJob& job, const StepHooks& hooks) {
  // a time that misses a multiple of the sample by rounding is one
  const auto slack = [](double ratio) { return std::max(1e-9, 1e-15 * ratio); };
  const double begin = job.begin / job.sample, end = job.end / job.sample;
  const double first = std::floor(begin + slack(begin)) + 1;
  const double last = std::max(first, std::ceil(end - slack(end)));
  const bool has_rows = job.csv || job.plot;
  const double stride = has_rows ? 1 : std::max(1., std::floor((last - first) / kBarStretches));
  ProgressBar bar;
  // what came in before the first step changes the state that it begins with
  if (hooks.before) hooks.before();
  if (job.record) describe(job);  // a record may begin with a state that is loaded
  hooks.after();
  State state = job.simulation.state();
  if (job.record && job.record->replay().loaded()) job.first = state;
  writeRow(state, job);
  // NOLINTNEXTLINE(clang-analyzer-security.FloatLoopCounter): whole numbers, which are exact
  for (double k = first; k < last; k += stride) {
    const double t = k * job.sample;
    if (!has_rows) stepTo(job.simulation, t, hooks);
    if (has_rows) writeRow(bodiesAt(job.simulation, t, hooks), job);
    bar.show((t - job.begin) / (job.end - job.begin));
  }
  state = stateAt(job.simulation, job.end, hooks);
  writeRow(state, job);
  return state;
}

State simulateOrReport(SimulateJob& job, StepWatch& watch) {
  SlowRunNotice slow(job.end);
  try {
    return simulate(job, hooksOf(job, slow, watch));
  } catch (const SimulationDiverged&) {
    job.messages.print();
    throw;
  }
}

void finish(SimulateJob& job) {
  if (job.csv) job.csv->finish();
  if (job.imu_csv) job.imu_csv->finish();
  if (job.bag) job.bag->finish();
  if (job.plot) job.plot->finish();
  if (job.options.save)
    saveState(*job.options.save, job.simulation.world(), job.simulation.state());
  std::string magnification = describeMagnification(job.simulation);
  if (magnification.empty() && !job.record)
    magnification = describeInstability(job.simulation, job.first);
  for (const std::string& text :
       {describeSubsteps(job.simulation), describePromise(job.simulation), magnification})
    if (!text.empty()) job.note(text);
  if (job.record && !job.record->remainder(job.end).empty())
    job.note(job.record->remainder(job.end));
  job.messages.print();
}

void drawPlots(SimulateJob& job) {
  const std::string& directory = *job.options.plot;
  const auto note = [&job](const std::string& text) { job.note(text); };
  if (hasGnuplot())
    note(plotRun({PlotFiles::pathsIn(directory), directory, {}}, note));
  else
    note(gnuplotIsMissing("the CSV files in " + oneLine(directory) + " are there"));
  job.messages.print();
}

void run(const SimulateOptions& options) {
  StepWatch watch([](const std::string& text) {
    std::fprintf(stderr, "%s\n", noticeLine("simulate", text).c_str());
  });
  watch.begin(StepWatch::kBeforeTheRun);
  SimulateJob job(options);
  job.openInputs();
  job.openOutputs();
  if (!job.record) describe(job);

  // forces that begin and end magnify errors, so that no choice of steps can promise the tolerance
  // beforehand
  if (job.world.solver.integrator == "auto" && hasOneSidedLaw(job.world))
    job.simulation.trackError();
  const auto begin = std::chrono::steady_clock::now();
  const State last = simulateOrReport(job, watch);
  const std::chrono::duration<double> wall = std::chrono::steady_clock::now() - begin;
  watch.end();
  finish(job);

  std::FILE* out = options.csv == "-" || options.imu_csv == "-" ? stderr : stdout;
  const std::string on_from = job.begin > 0 ? " on from " + shortest(job.begin) + " s" : "";
  std::fprintf(out, "%s: %.6g s%s in steps of %.6g s with %s, in %.3g s\n", options.scene.c_str(),
               last.t - job.begin, on_from.c_str(), job.world.solver.time_step,
               job.world.solver.integrator.c_str(), wall.count());
  const auto inputs = job.record ? job.record->effects(job.world) : std::vector<InputEffects>();
  std::fputs(runSummary(job.simulation.world(), job.first, last, inputs).c_str(), out);
  // results in files are not spoilt by a summary that nobody wants
  const bool to_file = job.csv || job.imu_csv || job.bag || job.plot || options.save;
  if (isOpen(out) || !to_file) requireWritten(out);
  if (job.plot) drawPlots(job);
}

}  // namespace
}  // namespace rigid_body_sim

int main(int argc, char** argv) {
  using namespace rigid_body_sim;
  return runProgram("simulate", [&] {
    const SimulateOptions options = parseSimulateOptions(argc, argv);
    if (options.help)
      print(simulateHelp());
    else
      run(options);
  });
}
