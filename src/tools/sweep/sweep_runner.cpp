#include "tools/sweep/sweep_runner.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/run/solved_run.hpp"
#include "dynamics/step_too_long.hpp"
#include "programs/usage.hpp"
#include "scene/files/number_text.hpp"
#include "scene/message_text.hpp"
#include "scene/study/read_record.hpp"
#include "tools/common/motion_numbers.hpp"
#include "tools/common/state_at.hpp"
#include "tools/sweep/error_report.hpp"
#include "tools/sweep/solved_step.hpp"

namespace rigid_body_sim {
namespace {

std::size_t bodyNamed(const World& world, const std::string& name) {
  const auto body = std::find_if(world.bodies.begin(), world.bodies.end(),
                                 [&](const Body& b) { return b.name == name; });
  return static_cast<std::size_t>(body - world.bodies.begin());
}

/// A message as a field of a table.
std::string field(std::string text) {
  for (char& c : text)
    if (c == ',' || c == '"') c = ';';
  return oneLine(std::move(text));
}

void appendField(double x, std::string& row) {
  row += ',';
  appendNumber(x, row);
}

/// The end of a row that is a result.
void appendError(const ErrorReport& error, RunRows& rows) {
  if (error.estimate) {
    appendField(error.estimate->attitude, rows.row);
    appendField(error.estimate->position, rows.row);
  } else {
    rows.row += ",,";
  }
  rows.row += ",done\n";
  rows.doubt = error.doubt;
}

}  // namespace

SweepRunner::SweepRunner(const SweepInputs& inputs)
    : inputs_(inputs),
      scene_(inputs.scene_text, inputs.context, inputs.study),
      draws_(inputs.study) {
  const Built built = build();
  notices_ = scene_.scene().notices;
  nominal_duration_ = built.duration;
  for (std::size_t i = 0; i < inputs.study.vary.size(); ++i)
    read_backs_.emplace_back(inputs.study.vary[i].path, scene_.bodyOf(i));
  for (std::size_t i = 0; i < built.world.bodies.size(); ++i)
    if (moves(built.world.bodies[i])) moving_.push_back(i);
  findRecords(built.world);
  findColumns(built.world);
}

SweepRunner::Built SweepRunner::build() {
  const Scene& scene = scene_.scene();
  Built built{buildWorld(scene), {}, inputs_.study.duration.value_or(scene.horizon)};
  built.world.solver.threads = 1;  // runs are what cores are for
  built.initial = initialState(scene, built.world);
  return built;
}

void SweepRunner::findRecords(const World& world) {
  const std::vector<std::string>& names = quantityNames();
  for (const RecordDef& def : inputs_.study.record) {
    Quantity quantity;
    quantity.body = bodyNamed(world, def.quantity.body);
    if (quantity.body == world.bodies.size()) {
      std::vector<std::string> known;
      for (const Body& body : world.bodies) known.push_back(body.name);
      throw SceneError(inputs_.study.source, def.line,
                       "record." + def.name + ": unknown body '" + printable(def.quantity.body) +
                           "' (known: " + nameList(known) + ")" +
                           didYouMean(def.quantity.body, known));
    }
    if (world.bodies[quantity.body].absent)
      throw SceneError(inputs_.study.source, def.line,
                       "record." + def.name + ": body '" + def.quantity.body +
                           "' is absent in the scene, and nothing brings it in during a sweep; "
                           "remove 'absent: true' there, or record another body");
    quantity.index = static_cast<std::size_t>(
        std::find(names.begin(), names.end(), def.quantity.name) - names.begin());
    records_.push_back({def, quantity});
  }
  const auto varies = [&](const Varied& varied) { return varied.path == "horizon"; };
  const std::vector<Varied>& vary = inputs_.study.vary;
  if (!inputs_.study.duration && std::any_of(vary.begin(), vary.end(), varies)) return;
  constexpr std::size_t kHeight = 2;  // pz
  if (!records_.empty())
    fan_ = records_.front().quantity;
  else if (!moving_.empty())
    fan_ = Quantity{moving_.front(), kHeight};
}

void SweepRunner::findColumns(const World& world) {
  columns_.push_back("run");
  for (std::size_t i = 0; i < inputs_.study.vary.size(); ++i) {
    const Varied& varied = inputs_.study.vary[i];
    SceneValue shape = scene_.own(i);
    if (const auto* list = std::get_if<ListDistribution>(&varied.distribution))
      shape = list->values.front();
    if (const auto* grid = std::get_if<GridDistribution>(&varied.distribution))
      shape = grid->values.front();
    if (std::holds_alternative<NormalDistribution>(varied.distribution) ||
        std::holds_alternative<UniformDistribution>(varied.distribution))
      shape = SceneValue::of(0);
    const bool is_named = std::holds_alternative<ListDistribution>(varied.distribution) ||
                          std::holds_alternative<GridDistribution>(varied.distribution);
    is_number_.insert(is_number_.end(), shape.words.size(), !is_named);
    for (std::size_t k = 0; k < shape.words.size(); ++k)
      columns_.push_back(varied.path + (shape.is_list ? "[" + std::to_string(k) + "]" : ""));
  }
  varied_columns_ = columns_.size() - 1;
  for (const std::size_t i : moving_)
    for (std::size_t k = 0; k < kMotionNumbers; ++k)
      columns_.push_back(world.bodies[i].name + "." + quantityNames()[k]);
  for (const RunRecorder::Record& record : records_) columns_.push_back(record.def.name);
  for (const char* last : {"attitude_error", "position_error", "status"}) columns_.push_back(last);
}

std::vector<double> SweepRunner::fanInstants() const {
  std::vector<double> instants;
  for (int k = 0; fan_ && k <= kFanInstants; ++k)
    instants.push_back(nominal_duration_ * k / kFanInstants);
  return instants;
}

std::string SweepRunner::fanName() const {
  if (!fan_) return "";
  return scene_.read().bodies[fan_->body].name + "." + quantityNames()[fan_->index];
}

void SweepRunner::setValues(std::int64_t number) {
  for (std::size_t i = 0; i < read_backs_.size(); ++i)
    if (const std::optional<double> x = draws_.number(i, number))
      scene_.set(i, *x);
    else if (const SceneValue* named = draws_.named(i, number))
      scene_.set(i, *named);
    else
      scene_.set(i, draws_.rotated(i, number, scene_.own(i)));
}

std::string SweepRunner::sceneOf(std::int64_t number) {
  setValues(number);
  build();
  return scene_.yaml();
}

RunRows SweepRunner::run(std::int64_t number) {
  constexpr std::size_t kFieldBytes = 20;
  const bool with_fan = number < SweepInfo::kFanRuns && fan_;
  RunRows rows;
  rows.row.reserve(columns_.size() * kFieldBytes);
  rows.row = std::to_string(number);
  std::size_t values_end = 0;  // in the row
  setValues(number);
  const auto refuse = [&](const std::string& status) {
    if (values_end == 0) values_end = appendValues(nullptr, rows.row);
    rows.row.resize(values_end);
    rows.row.append(columns_.size() - varied_columns_ - 1, ',');
    rows.row += field(status) + "\n";
    if (with_fan) rows.fan = std::to_string(number) + std::string(kFanInstants + 1, ',') + "\n";
    rows.refusal = status;
  };
  try {
    Built built = build();
    values_end = appendValues(&built, rows.row);
    if (isSolvedThroughout(built.world) && !RunRecorder::areNeededWithin(records_))
      solve(built, with_fan, number, rows);
    else
      simulate(std::move(built), with_fan, number, rows);
  } catch (const SceneError& error) {
    refuse(std::string("refused: ") + error.what());
  } catch (const SimulationDiverged& error) {
    refuse(std::string("diverged: ") + error.what());
  } catch (const StepTooLong& error) {
    refuse(std::string("diverged: ") + error.what());
  } catch (const std::invalid_argument& error) {
    refuse(std::string("refused: ") + error.what());
  }
  return rows;
}

Simulation SweepRunner::simulationOf(Built built) const {
  if (RunRecorder::areNeededWithin(records_))
    return Simulation(std::move(built.world), std::move(built.initial));
  return quickSimulation(std::move(built.world), built.initial, built.duration);
}

void SweepRunner::simulate(Built built, bool with_fan, std::int64_t number, RunRows& rows) const {
  const double duration = built.duration;
  const bool within = RunRecorder::areNeededWithin(records_);
  std::optional<Built> again;  // what is gone through a second time
  if (with_fan || within) again = built;
  Simulation run = simulationOf(std::move(built));
  const bool solved = staysSolved(run);
  if (!solved) run.trackError();
  std::optional<RunRecorder> recorder;
  if (!records_.empty()) recorder.emplace(records_, run);
  std::string fan;
  if (with_fan && !within && solved)
    fan = fanOf(*again);
  else
    follow(run, duration, within ? &*recorder : nullptr, with_fan ? &fan : nullptr);
  const State end = bodiesAt(run, duration);
  if (recorder) recorder->finish(end);

  appendStates(run.world(), end, rows.row);
  if (within)
    appendRecords(recorder->values(Simulation(again->world, again->initial), end.t), rows.row);
  else if (recorder)
    appendRecords(recorder->values(run, 0), rows.row);
  appendError(solved ? ErrorReport{ErrorEstimate(), ""} : errorReport(run, duration), rows);
  if (with_fan) rows.fan = std::to_string(number) + fan + "\n";
}

/// Without a simulation, as nothing is asked for but the end.
void SweepRunner::solve(const Built& built, bool with_fan, std::int64_t number,
                        RunRows& rows) const {
  if (with_fan) rows.fan = std::to_string(number) + fanOf(built) + "\n";
  State end;
  end.t = built.duration;
  end.bodies = solvedAfter(built.world, built.initial, built.duration);
  appendStates(built.world, end, rows.row);
  for (const auto& [def, quantity] : records_)
    appendField(quantity.of(built.world.bodies[quantity.body], end.bodies[quantity.body]),
                rows.row);
  appendError({ErrorEstimate(), ""}, rows);
}

/// Of motions that are solved: a state within a long step is found from its start on, each anew, so
/// that the steps are those of the fan.
std::string SweepRunner::fanOf(const Built& built) const {
  World by_instants = built.world;
  by_instants.solver.time_step = built.duration / kFanInstants;
  Simulation beside(std::move(by_instants), built.initial);
  std::string fan;
  follow(beside, built.duration, nullptr, &fan);
  return fan;
}

/// Steps the run to its end. recorder, fan: null where they are not needed.
void SweepRunner::follow(Simulation& run, double duration, RunRecorder* recorder,
                         std::string* fan) const {
  StepHooks hooks;
  if (recorder) {
    recorder->look();
    hooks.after = [recorder] { recorder->look(); };
  }
  for (int k = 0; fan && k <= kFanInstants; ++k) {
    const State state = bodiesAt(run, duration * k / kFanInstants, hooks);
    appendField(fan_->of(run.world().bodies[fan_->body], state.bodies[fan_->body]), *fan);
  }
  if (!fan && recorder) bodiesAt(run, duration, hooks);
}

/// Returns where the values end in the row. built: null where there is no world to read them from.
std::size_t SweepRunner::appendValues(const Built* built, std::string& row) const {
  for (std::size_t i = 0; i < read_backs_.size(); ++i) {
    const SceneValue& given = scene_.now(i);
    std::optional<SceneValue> other;
    if (built)
      other =
          otherReadBack(given, read_backs_[i].numbers(scene_.read(), built->world, built->initial));
    for (const SceneValue::Word& word : (other ? *other : given).words) {
      row += ',';
      row += word.number ? word.text : field(word.text);
    }
  }
  return row.size();
}

void SweepRunner::appendRecords(const std::vector<std::optional<double>>& values,
                                std::string& row) const {
  for (const std::optional<double>& value : values)
    if (value)
      appendField(*value, row);
    else
      row += ',';
}

void SweepRunner::appendStates(const World& world, const State& end, std::string& row) const {
  for (const std::size_t i : moving_)
    for (const double x : motionNumbers(toBodyFrameMotion(world.bodies[i], end.bodies[i])))
      appendField(x, row);
}

}  // namespace rigid_body_sim
