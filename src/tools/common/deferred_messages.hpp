#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace rigid_body_sim {

/// Lines for standard error that wait until no input can be at fault any more: the line that
/// reports a fault stands alone.
class DeferredMessages {
 public:
  void add(const std::string& line) { lines_.push_back(line); }

  /// Prints what has been added since the last call.
  void print() {
    for (const std::string& line : lines_) std::fprintf(stderr, "%s\n", line.c_str());
    lines_.clear();
  }

 private:
  std::vector<std::string> lines_;
};

}  // namespace rigid_body_sim
