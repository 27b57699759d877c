#pragma once

#include <rigid_body_sim/dynamics/force_law.hpp>

namespace rigid_body_sim {

/// What all laws of contact have in common, whatever touches what.
class ContactLaw : public ForceLaw {
 public:
  const char* name() const final { return "contact"; }
  unsigned needs() const final { return kCoupling | kDamping | kLawStates | kContact; }
  bool hasRate() const final { return true; }
  bool startsAnew() const final { return true; }
  bool foreseesInFlight() const final { return true; }
  bool switchesSmoothly() const final { return true; }
};

}  // namespace rigid_body_sim
