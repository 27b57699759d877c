#pragma once

#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/world.hpp>
#include <rigid_body_sim/scene/scene.hpp>

#include "ros/inputs/input_replay.hpp"
#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {

struct BagInputs {
  std::vector<TimedInput> inputs;  ///< in the order of their steps
  TimeOrigin origin;               ///< where the run starts in the time of the bag
  std::string notice;  ///< one line, for a bag that does not record how the run was; else empty
  bool is_of_later_run = false;  ///< whether runs that a reset or a load has ended come before
};

/// The inputs that a bag has recorded: those of its one topic of type Input. A bag without has the
/// messages of <body>/wrench, of <body>/command and of its one topic each of the types
/// AppliedWrench and AppliedWrenches, by the rules of the node with its default timeouts. Each is
/// taken over at the first step at or after its time in the bag, which counts from zero if it is
/// that of a simulation clock, else from the beginning of the bag.
///
/// Throws std::runtime_error with one line, the path first, for a bag that cannot be read, that
/// holds the inputs of several nodes or none at all, and as lastRun. world: that of the scene.
BagInputs readBagInputs(const std::string& path, const Scene& scene, const World& world);

}  // namespace rigid_body_sim
