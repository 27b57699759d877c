#pragma once

#include <algorithm>
#include <string>

#include "math/shortest.hpp"

namespace rigid_body_sim {

/// The tightest tolerance of auto that contact is integrated to: a tighter one changes nothing.
constexpr double kTightestInContact = 1e-12;

/// The least bound on the error estimate of a step in contact to which trials go: places and
/// attitudes are rounding there. Energy gains from a tighter one, which a tolerance may ask for.
constexpr double kLeastContactBound = 1e-14;

/// Evaluations of all forces on a body that a time step may take in contact: a thousand times what
/// stiff contact takes, and minutes at most.
constexpr double kMaxContactWork = 3e8;
inline double maxContactWork(double time_step) {
  constexpr double kPerSecond = 1e9, kLeast = 1e7;
  return std::clamp(kPerSecond * time_step, kLeast, kMaxContactWork);
}

/// What is said of a step that would take more.
inline std::string tooMuchContact(double work) {
  return "a step in contact takes more than " + shortest(work) +
         " evaluations of the forces on a body: take a shorter time_step, or a lower stiffness";
}

/// By how much looser that bound is in the run that estimates the error.
constexpr double kCompanionShare = 100;

/// What the error estimate of a step in contact may reach, before a trial has shown how errors
/// grow. They grow from impact to impact, so that it lies far below the tolerance.
inline double contactStepBound(double tolerance) {
  constexpr double kShare = 1e-4, kLoosest = 1e-6;
  return std::min(kShare * std::max(tolerance, kTightestInContact), kLoosest);
}

}  // namespace rigid_body_sim
