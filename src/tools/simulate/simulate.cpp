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
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/state_file.hpp>

#include "math/shortest.hpp"
#include "programs/distinct_files.hpp"
#include "programs/formatted.hpp"
#include "programs/run_program.hpp"
#include "programs/standard_streams.hpp"
#include "programs/step_watch.hpp"
#include "programs/tool_scene.hpp"
#include "programs/usage.hpp"
#include "ros/outputs/instants.hpp"
#include "scene/message_text.hpp"
#include "tools/common/deferred_messages.hpp"
#include "tools/common/gnuplot.hpp"
#include "tools/common/progress_bar.hpp"
#include "tools/common/slow_run_notice.hpp"
#include "tools/common/state_at.hpp"
#include "tools/plot/plot_run.hpp"
#include "tools/simulate/bag_output.hpp"
#include "tools/simulate/csv_writer.hpp"
#include "tools/simulate/imu_csv.hpp"
#include "tools/simulate/plot_files.hpp"
#include "tools/simulate/recorded_run.hpp"
#include "tools/simulate/run_summary.hpp"
#include "tools/simulate/simulate_options.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kBagSample = 0.01;    // [s] as the node publishes by default
constexpr double kBarStretches = 200;  // of a run that writes no rows

void requireDistinctFiles(const SimulateOptions& options) {
  std::vector<NamedFile> files{{"the scene", options.scene, false}};
  if (options.wrench_bag) files.push_back({"--wrench-bag", *options.wrench_bag, false});
  if (options.csv && *options.csv != "-") files.push_back({"--csv", *options.csv, true});
  if (options.imu_csv && *options.imu_csv != "-")
    files.push_back({"--imu-csv", *options.imu_csv, true});
  if (options.bag) files.push_back({"--bag", *options.bag, true});
  if (options.plot)
    for (const std::string& path : PlotFiles::pathsIn(*options.plot))
      files.push_back({"a file of --plot", path, true});
  if (options.load) files.push_back({"--load", *options.load, false});
  if (options.save) files.push_back({"--save", *options.save, true});
  requireDistinct(files);
}

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
  requireCountable(options.duration.value_or(scene.horizon), scene.time_step, "steps");
  return scene;
}

/// One call of the program: what it reads, computes and writes.
struct Job {
  explicit Job(const SimulateOptions& given)
      : options(given),
        scene(sceneOf(options)),
        world(buildWorld(scene)),
        simulation(world, initialState(scene, world)),
        first(simulation.state()) {}

  void note(const std::string& text) { messages.add(noticeLine("simulate", text)); }

  SimulateOptions options;
  Scene scene;
  World world;
  Simulation simulation;
  State first;
  DeferredMessages messages;
  std::unique_ptr<RecordedRun> record;  // of --wrench-bag
  double begin = 0, end = 0;            // [s]
  double sample = 0;                    // [s]
  std::unique_ptr<CsvWriter> csv;
  std::unique_ptr<ImuCsv> imu_csv;
  std::unique_ptr<BagOutput> bag;
  std::unique_ptr<PlotFiles> plot;
};

void load(const std::string& path, Job& job) {
  State state = loadState(path, job.world);
  try {
    job.simulation.load(state);
  } catch (const std::invalid_argument& refused) {
    throw SceneError(path, 0, refused.what());
  }
  job.first = std::move(state);
}

void openInputs(Job& job) {
  for (const std::string& notice : job.scene.notices) job.note(notice);
  const SimulateOptions& options = job.options;
  if (options.wrench_bag) {
    job.record = std::make_unique<RecordedRun>(*options.wrench_bag, job.scene, job.world);
    if (!job.record->notice().empty()) job.note(job.record->notice());
  }
  if (options.load) load(*options.load, job);
  job.begin = job.record ? job.record->begin() : job.simulation.time();
  if (job.record && !options.duration && !job.record->lengthNotice(job.scene).empty())
    job.note(job.record->lengthNotice(job.scene));
  const double end = job.record ? job.record->end(job.scene) : job.begin + job.scene.horizon;
  job.end = options.duration ? job.begin + *options.duration : end;
  job.sample = options.sample.value_or(job.scene.time_step);
  requireCountable(job.end, job.scene.time_step, "steps");
  requireCountable(job.end, job.sample, "samples");
  const double h = job.scene.time_step;
  if (options.duration && *options.duration > 0 &&
      job.end - job.begin < instantRounding(job.end, h))
    throw UsageError("--duration must be at least a billionth of the time step " + shortest(h) +
                     " s, and of the time at which it begins, got " + shortest(*options.duration) +
                     " s; a shorter --time-step is needed");
  if (options.save && std::abs(job.end - std::round(job.end / h) * h) > 1e-6 * h)
    throw UsageError(
        "--save needs an end at a step: --duration must be a multiple of the time step " +
        shortest(h) + " s, got an end at " + shortest(job.end) + " s");
  if (options.save) requireSavable(*options.save);
}

void openImuCsv(Job& job) {
  if (job.world.imus.empty())
    throw UsageError("--imu-csv goes with a scene in which a body has imus");
  for (const Imu& imu : job.world.imus)
    requireCountable(job.end, 1 / imu.rate, "samples of IMU " + imu.name);
  job.imu_csv = std::make_unique<ImuCsv>(*job.options.imu_csv, job.simulation);
  job.imu_csv->finish();
}

void openOutputs(Job& job) {
  if (job.options.csv) {
    job.csv = std::make_unique<CsvWriter>(*job.options.csv);
    job.csv->finish();  // the header: a file that takes nothing is reported before the run
  }
  if (job.options.imu_csv) openImuCsv(job);
  if (job.options.bag)
    job.bag = std::make_unique<BagOutput>(
        *job.options.bag, 1 / job.options.sample.value_or(kBagSample),
        job.record ? job.record->origin() : TimeOrigin(), job.scene, job.simulation);
  if (job.options.plot) job.plot = std::make_unique<PlotFiles>(*job.options.plot, job.simulation);
}

/// The steps up to the next at which an input comes, something is written or the clock is read.
std::int64_t freeSteps(const Job& job, const SlowRunNotice& slow) {
  double written = std::numeric_limits<double>::infinity();  // [s]
  if (job.imu_csv) written = std::min(written, job.imu_csv->next());
  if (job.bag) written = std::min(written, job.bag->nextInstant());
  std::int64_t until = std::min(slow.nextLook(), stepsBy(job.simulation, written));
  if (job.record) until = std::min(until, job.record->nextStep());
  return until - job.simulation.steps();
}

/// As the node: inputs are applied before a step, the state is published after it.
StepHooks hooksOf(Job& job, SlowRunNotice& slow, StepWatch& watch) {
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
    if (!text.empty()) job.note(text);
    // though an input to come may be at fault: the user waits now
    if (!text.empty()) job.messages.print();
  };
  hooks.free_steps = [&job, &slow] { return freeSteps(job, slow); };
  return hooks;
}

void writeRow(const State& state, Job& job) {
  if (job.csv) job.csv->write(job.simulation.world(), state);
  if (job.plot) job.plot->write(state);
}

void describe(Job& job) {
  for (const std::string& line : describeSolution(job.simulation)) job.messages.add(line);
  // else an input to come may not be of this scene
  if (!job.record || job.record->replay().isDone()) job.messages.print();
}

/// Runs to the end, a row at every sample and at the end. Returns the last state.
State simulate(Job& job, const StepHooks& hooks) {
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

State simulateOrReport(Job& job, StepWatch& watch) {
  SlowRunNotice slow(job.end);
  try {
    return simulate(job, hooksOf(job, slow, watch));
  } catch (const SimulationDiverged&) {
    job.messages.print();
    throw;
  }
}

void finish(Job& job) {
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

void drawPlots(Job& job) {
  const std::string& directory = *job.options.plot;
  const auto note = [&job](const std::string& text) { job.note(text); };
  if (hasGnuplot())
    note(plotRun({PlotFiles::pathsIn(directory), directory, {}}, note));
  else
    note(gnuplotIsMissing("the CSV files in " + oneLine(directory) + " are there"));
  job.messages.print();
}

void run(const SimulateOptions& options) {
  requireDistinctFiles(options);
  StepWatch watch([](const std::string& text) {
    std::fprintf(stderr, "%s\n", noticeLine("simulate", text).c_str());
  });
  watch.begin(StepWatch::kBeforeTheRun);
  Job job(options);
  openInputs(job);
  openOutputs(job);
  if (!job.record) describe(job);

  // contacts magnify errors, so that no choice of steps can promise the tolerance beforehand
  if (job.world.solver.integrator == "auto" && hasContact(job.world)) job.simulation.trackError();
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
