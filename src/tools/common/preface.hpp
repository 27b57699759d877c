#pragma once

#include <cstdio>
#include <string>
#include <vector>

namespace rigid_body_sim {

/// What a program says on standard error before its results: held until no input can be at fault
/// any more, as the line that tells of a fault stands there alone.
class Preface {
 public:
  void add(const std::string& line) { lines_.push_back(line); }

  /// Once; later calls say what has been added since.
  void say() {
    for (const std::string& line : lines_) std::fprintf(stderr, "%s\n", line.c_str());
    lines_.clear();
  }

 private:
  std::vector<std::string> lines_;
};

}  // namespace rigid_body_sim
