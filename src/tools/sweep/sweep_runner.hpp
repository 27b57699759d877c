#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <rigid_body_sim/scene/build_world.hpp>

#include "scene/study/draws.hpp"
#include "scene/study/read_back.hpp"
#include "scene/study/varied_scene.hpp"
#include "tools/sweep/run_recorder.hpp"
#include "tools/sweep/sweep_info.hpp"
#include "tools/sweep/table_fields.hpp"

namespace rigid_body_sim {

/// What all runs of a sweep have in common.
struct SweepInputs {
  Study study;
  std::string scene_text, study_text;  ///< as they were read
  ReadContext context;                 ///< of the scene
};

/// How a run ended: its rows, each with its end of line.
struct RunRows {
  std::string row;
  std::string fan;      ///< empty: the run has none
  std::string refusal;  ///< why it is no result; empty: it is one
  std::string doubt;  ///< why it may be wrong by more than it should; empty: it is not known to be
};

/// Makes runs of a study, one after the other, each from its number alone. Every thread has its
/// own.
class SweepRunner {
 public:
  /// A row of the fan has so many instants and the start.
  static constexpr int kFanInstants = 40;

  /// Throws SceneError for a scene or a study at fault.
  explicit SweepRunner(const SweepInputs& inputs);

  /// Throws SceneError for a path that varies nothing, for a value of a list or grid that the scene
  /// refuses, and for another distribution where it refuses all that was tried.
  void checkPaths();

  std::int64_t runs() const { return draws_.runs(); }
  RunRows run(std::int64_t number);

  /// The scene of a run, as YAML. Throws SceneError where the scene refuses a value.
  std::string sceneOf(std::int64_t number);

  const std::vector<std::string>& columns() const { return columns_; }
  RowForm rowForm() const {
    return {columns_.size(), varied_columns_, records_.size(), is_number_};
  }
  const std::vector<RunRecorder::Record>& records() const { return records_; }

  /// Instants of the fan [s], and its quantity; none where runs differ in their duration.
  std::vector<double> fanInstants() const;
  std::string fanName() const;

  const std::vector<std::string>& notices() const { return notices_; }
  const ReadContext& context() const { return scene_.context(); }

 private:
  struct Built {
    World world;
    State initial;
    double duration = 0;  // [s]
  };

  /// What the other values of a path are compared with.
  struct Reference {
    SceneValue value;
    Built built;
    bool is_run = false;
    std::optional<State> end;  // once it is run; none: it has no result
  };

  void findColumns(const World& world);
  void findRecords(const World& world);
  Built build();
  void setValues(std::int64_t number);
  void checkPath(std::size_t index);
  bool differAmong(const std::vector<SceneValue>& values, std::size_t index);
  bool reachesBesideOthers(std::size_t index, std::vector<SceneValue> values);
  bool isAsInTheScene(std::size_t index, const SceneValue& value, bool must_differ);
  std::vector<SceneValue> probesOf(std::size_t index) const;
  std::optional<Built> builtWith(std::size_t index, const SceneValue& value, std::string& refusal);
  std::optional<State> endOf(const Built& built) const;
  bool movesAlike(Reference& reference, const Built& other, const std::string& path);
  Simulation simulationOf(Built built) const;
  void simulate(Built built, bool with_fan, std::int64_t number, RunRows& rows) const;
  void solve(const Built& built, bool with_fan, std::int64_t number, RunRows& rows) const;
  std::string fanOf(const Built& built) const;
  void appendRecords(const std::vector<std::optional<double>>& values, std::string& row) const;
  void follow(Simulation& run, double duration, RunRecorder* recorder, std::string* fan) const;
  std::size_t appendValues(const Built* built, std::string& row) const;
  void appendStates(const World& world, const State& end, std::string& row) const;

  const SweepInputs& inputs_;
  VariedScene scene_;
  Draws draws_;
  std::vector<ReadBack> read_backs_;  ///< path by path
  std::vector<std::size_t> moving_;   ///< bodies
  std::vector<RunRecorder::Record> records_;
  std::optional<Quantity> fan_;
  std::vector<std::string> columns_;
  std::size_t varied_columns_ = 0;
  std::vector<bool> is_number_;  ///< varied columns that never hold a word
  double nominal_duration_ = 0;  // [s]
  std::vector<std::string> notices_;
};

}  // namespace rigid_body_sim
