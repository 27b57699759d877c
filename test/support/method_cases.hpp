#pragma once

#include <vector>

#include "dynamics/methods/catalogue.hpp"
#include "support/worlds.hpp"

/// A motion for every kind of wrench and law, which the tests of all methods share.
namespace rigid_body_sim::test {

struct Case {
  const char* name;
  Bench bench;
  bool torque_free = false;
};

Bench freeBody();

/// A body pushed in the axes and at a point of a second body, which tumbles freely.
Bench coupledBodies();

/// A wrench in the world that starts and ends inside a step.
Bench interruptedPush();

Bench draggedSpring();

/// Swings on a pivot, pushed at a point of the world.
Bench pushedOnPivot();

/// A pendulum of two bodies: one on a pivot, another on a spring between them.
Bench bodyHungOnPivoted();

std::vector<Case> allCases();

/// What an integrator has to support for the case.
unsigned needsOf(const Case& c);

/// The cases that an integrator supports.
std::vector<Case> casesFor(const Method& method);

}  // namespace rigid_body_sim::test
