#pragma once

#include <functional>
#include <memory>
#include <string>

#include <rosbag/bag.h>

#include "ros/outputs/outputs.hpp"

namespace rigid_body_sim {

/// A run written to a bag as a node /rigid_body_node with publish_clock publishes it: the same
/// topics, stamps and values.
class BagOutput {
 public:
  /// States at `rate` [1/s], stamped from the origin on. The simulation, that of the scene, is
  /// watched, not copied. Throws std::runtime_error, the path first, when the bag cannot be
  /// written; so do the others.
  BagOutput(const std::string& path, double rate, const TimeOrigin& origin, const Scene& scene,
            const Simulation& simulation);

  /// Writes what is due at the step that the simulation has come to.
  void writeDue();

  /// Writes what is due before the next step, up to time t_end [s].
  void writeWithinStep(double t_end);

  /// See Outputs.
  double nextInstant() const { return outputs_->nextInstant(); }

  /// Bodies have been moved other than by time.
  void breakTrails() { outputs_->breakTrails(); }

  /// Inputs have been applied.
  void followBodies() { outputs_->followBodies(); }

  /// Closes the bag.
  void finish();

 private:
  void guarded(const std::function<void()>& action);

  std::string path_;
  std::unique_ptr<rosbag::Bag> bag_;
  TimeOrigin origin_;
  std::unique_ptr<Outputs> outputs_;
};

}  // namespace rigid_body_sim
