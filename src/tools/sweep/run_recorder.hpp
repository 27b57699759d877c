#pragma once

#include <optional>
#include <vector>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "scene/study/study.hpp"

namespace rigid_body_sim {

/// A quantity of a body of a world.
struct Quantity {
  std::size_t body = 0;
  std::size_t index = 0;  ///< in quantityNames()

  double of(const Body& body_def, const BodyState& state) const;
};

/// Follows a run for what a study records of it. What is looked for is first found between time
/// steps, then located within the steps.
class RunRecorder {
 public:
  struct Record {
    RecordDef def;
    Quantity quantity;
  };

  RunRecorder(const std::vector<Record>& records, const Simulation& simulation);

  /// At the present of the run; to be called at its start and after every step.
  void look() { look(simulation_.time(), nullptr); }

  /// At its end, which may lie within a step.
  void finish(const State& end) { look(end.t, &end); }

  /// The values found, in the order of the records; none: it never happened. start: the run before
  /// its first step, which goes through the steps again where something is to be located. end [s]:
  /// of the run.
  std::vector<std::optional<double>> values(Simulation start, double end) const;

  /// Whether these records have to be looked at during a run.
  static bool areNeededWithin(const std::vector<Record>& records);

 private:
  struct Found {
    std::optional<double> value;
    double before = 0;  ///< [s] the instant looked at before the one of the value
    double at = 0;      ///< [s]
    double last = 0;    ///< [s] looked at last
    double after = 0;   ///< [s] the instant looked at after `at`; 0: none
  };

  void look(double t, const State* end);
  void locate(std::size_t index, const Simulation& run, double from, double to,
              std::optional<double>& value) const;

  const std::vector<Record>& records_;
  const Simulation& simulation_;
  std::vector<Found> found_;
};

}  // namespace rigid_body_sim
