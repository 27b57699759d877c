#pragma once

#include <stdexcept>
#include <string>

namespace rigid_body_sim {

/// Exit status of every program.
enum ExitCode { kDone = 0, kBadInput = 1, kWrongUsage = 2, kDiverged = 3 };

/// Wrong usage of a command line; what() is one line.
class UsageError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// The value of an option, named without its dashes. Throws UsageError unless it is finite and > 0.
double positiveNumber(const std::string& option, const char* text);

}  // namespace rigid_body_sim
