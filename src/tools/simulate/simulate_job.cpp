#include "tools/simulate/simulate_job.hpp"

#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/state_file.hpp>

#include "math/instant_rounding.hpp"
#include "math/shortest.hpp"
#include "programs/distinct_files.hpp"
#include "programs/tool_scene.hpp"
#include "programs/usage.hpp"
#include "tools/common/state_at.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kBagSample = 0.01;  // [s] as the node publishes by default

/// files: what is read of the scene.
void requireDistinctFiles(const SimulateOptions& options, std::vector<NamedFile> files) {
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
  requireDistinctFiles(options, filesOfScene(options.scene, {}));
  Scene scene = loadToolScene(options.scene);
  requireDistinctFiles(options, filesOfScene(scene.source, scene.files));
  scene.time_step = options.time_step.value_or(scene.time_step);
  scene.tolerance = options.tolerance.value_or(scene.tolerance);
  scene.threads = options.threads.value_or(scene.threads);
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

}  // namespace

SimulateJob::SimulateJob(const SimulateOptions& given)
    : options(given),
      scene(sceneOf(options)),
      world(buildWorld(scene)),
      simulation(world, initialState(scene, world)),
      first(simulation.state()) {}

void SimulateJob::note(const std::string& text) { messages.add(noticeLine("simulate", text)); }

void SimulateJob::load(const std::string& path) {
  State state = loadState(path, world);
  try {
    simulation.load(state);
  } catch (const std::invalid_argument& refused) {
    throw SceneError(path, 0, refused.what());
  }
  first = std::move(state);
}

void SimulateJob::openRecord(const std::string& path) {
  try {
    record = std::make_unique<RecordedRun>(path, scene, world);
  } catch (const std::runtime_error& fault) {
    throw std::runtime_error(std::string("--wrench-bag ") + fault.what());
  }
  if (!record->notice().empty()) note(record->notice());
}

void SimulateJob::openInputs() {
  for (const std::string& notice : scene.notices) note(notice);
  if (options.wrench_bag) openRecord(*options.wrench_bag);
  if (options.load) load(*options.load);
  begin = record ? record->begin() : simulation.time();
  if (record && !options.duration && !record->lengthNotice(scene).empty())
    note(record->lengthNotice(scene));
  const double horizon_end = record ? record->end(scene) : begin + scene.horizon;
  end = options.duration ? begin + *options.duration : horizon_end;
  sample = options.sample.value_or(scene.time_step);
  checkTimes();
  if (options.save) requireSavable(*options.save);
}

/// Throws UsageError where the run would have too many steps or samples, none, or no end to save.
void SimulateJob::checkTimes() const {
  requireCountable(end, scene.time_step, "steps");
  requireCountable(end, sample, "samples");
  const double h = scene.time_step;
  if (options.duration && *options.duration > 0 && end - begin < instantRounding(end, h))
    throw UsageError("--duration must be at least a billionth of the time step " + shortest(h) +
                     " s, and of the time at which it begins, got " + shortest(*options.duration) +
                     " s; a shorter --time-step is needed");
  if (options.save && std::abs(end - std::round(end / h) * h) > 1e-6 * h)
    throw UsageError(
        "--save needs an end at a step: --duration must be a multiple of the time step " +
        shortest(h) + " s, got an end at " + shortest(end) + " s");
}

void SimulateJob::openImuCsv() {
  if (world.imus.empty()) throw UsageError("--imu-csv goes with a scene in which a body has imus");
  for (const Imu& imu : world.imus)
    requireCountable(end, 1 / imu.rate, "samples of IMU " + imu.name);
  imu_csv = std::make_unique<ImuCsv>(*options.imu_csv, simulation);
  imu_csv->finish();
}

void SimulateJob::openOutputs() {
  if (options.csv) {
    csv = std::make_unique<CsvWriter>(*options.csv);
    csv->finish();  // the header: a file that takes nothing is reported before the run
  }
  if (options.imu_csv) openImuCsv();
  if (options.bag)
    bag = std::make_unique<BagOutput>(*options.bag, 1 / options.sample.value_or(kBagSample),
                                      record ? record->origin() : TimeOrigin(), scene, simulation);
  if (options.plot) plot = std::make_unique<PlotFiles>(*options.plot, simulation);
}

}  // namespace rigid_body_sim
