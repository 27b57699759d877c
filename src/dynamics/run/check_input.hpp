#pragma once

#include <rigid_body_sim/dynamics/world.hpp>

namespace rigid_body_sim {

/// Rules for what users of the library give. Each throws std::invalid_argument, with a line that
/// names the body, the rule and the value found.

void checkWorld(const World& world);
void checkState(const World& world, const State& state);

/// A body of the world.
void checkIndex(const World& world, std::size_t body);

/// A body of the world that is not fixed.
void checkBody(const World& world, std::size_t body);

/// A time [s] for which the next step is asked.
void checkTimeWithinStep(const World& world, double now, double t);

/// Of any body, one that is fixed, too.
void checkPose(const std::string& body, const BodyState& state);

void checkBodyState(const World& world, std::size_t body, const BodyState& state);

/// The given state of a body at t [s] must be the one that its motion from the anchor has led to:
/// to the bit, or but for last digits, where another machine has written it.
void checkFollows(const Body& body, const MotionAnchor& anchor, double t, const BodyState& led,
                  const BodyState& given);

/// A state that a run takes over has fixed bodies where the run began with them.
void checkFixed(const World& world, const State& given, const State& start);

/// What comes from outside while a run goes on must not make its totals infinite.
void requireFiniteEnergy(const Body& body, const BodyState& state);
void checkCommand(const World& world, const ActuatorCommand& command);
void checkWrench(const World& world, const PointWrench& wrench);

}  // namespace rigid_body_sim
