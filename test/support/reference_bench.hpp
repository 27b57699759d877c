#pragma once

#include "support/reference_motion.hpp"
#include "support/worlds.hpp"

/// The reference motion of a bench: the same wrenches and laws, written anew in long double.
namespace rigid_body_sim::test {

/// The motions after a duration, with all that acts on the bodies of the bench.
reference::Motions referenceRun(const Bench& bench, double duration);

struct MotionErrors {
  double attitude = 0;  ///< [rad] the worst of all bodies
  double position = 0;  ///< [m]
};

MotionErrors motionErrors(const State& state, const reference::Motions& motions);

}  // namespace rigid_body_sim::test
