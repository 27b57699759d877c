#pragma once

#include <optional>
#include <string>
#include <vector>

#include "dynamics/run/run.hpp"

namespace rigid_body_sim {

/// How far a body has come, as it is seen from instant to instant.
struct Path {
  BodyState last;
  double length = 0;  ///< [m]

  void goOn(const BodyState& now) {
    length += distanceBetween(now, last);
    last = now;
  }
};

/// Whether errors of a body [rad], [m] are beyond a tolerance: of attitude or, where it has come
/// further than its size, of position relative to its path.
bool isBeyond(double tolerance, double attitude, double position, const Body& body,
              const Path& path);

/// Estimates the error of a run by another at twice the step, which is given the same inputs.
class ErrorTracker {
 public:
  /// From now on.
  explicit ErrorTracker(const Run& run);

  /// To be called after every step of the run.
  void follow(const Run& run);

  /// A wrench that the run has taken over, from its present on.
  void put(const std::string& slot, const PointWrench& wrench);

  /// A command, likewise.
  void command(const ActuatorCommand& command);

  /// The run has changed otherwise: the other one starts from it at its next step of even count.
  void restart() {
    coarse_.reset();
    paths_.clear();
  }

  const ErrorEstimate& estimate() const { return estimate_; }

 private:
  void start(const Run& run);
  void compare(const Run& run, const Group& group);

  std::optional<Run> coarse_;  // none before a step of even count, and where all is solved
  ErrorEstimate estimate_;
  std::vector<Path> paths_;  // by body; empty before a step is followed
};

}  // namespace rigid_body_sim
