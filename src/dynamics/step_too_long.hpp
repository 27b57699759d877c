#pragma once

#include <stdexcept>

namespace rigid_body_sim {

/// A step over which a method cannot follow the motion, in however many substeps.
class StepTooLong : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace rigid_body_sim
