#pragma once

#include <string>
#include <vector>

#include "support/contact_benches.hpp"

/// Scenes of contact the cost of which was stated before they were built: evaluations of all
/// forces, those that locate events included, where a step may err by 1e-9.
namespace rigid_body_sim::test {

struct CostedContact {
  std::string name;
  Bench bench;
  double duration;       // [s]
  int events;            // of the prototype: touches, releases, slips, grips, ends of normal forces
  double evaluations;    // likewise
  double metre, radian;  // by which that erred
};

Bench underGravity();

/// At the breakaway that scenes have by default, which asks for shorter steps than were stated.
CostedContact stifferRolling();

std::vector<CostedContact> costedContacts();

}  // namespace rigid_body_sim::test
