#pragma once

#include <cmath>

#include <rigid_body_sim/dynamics/force_law.hpp>

namespace rigid_body_sim {

/// Whether a state that holds modes as a sum of bits does so: a whole number up to the sum of all.
inline bool isSumOfBits(double modes, unsigned all) {
  return modes >= 0 && modes <= all && modes == std::floor(modes);
}

/// What all laws of contact have in common, whatever touches what.
class ContactLaw : public ForceLaw {
 public:
  const char* name() const final { return "contact"; }
  unsigned needs() const final { return kCoupling | kDamping | kLawStates | kContact; }
  bool hasRate() const final { return true; }
  bool isOneSided() const final { return true; }
  bool switchesSmoothly() const final { return true; }
};

}  // namespace rigid_body_sim
