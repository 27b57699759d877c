#pragma once

#include <functional>
#include <string>

namespace rigid_body_sim::extremes {

/// What became of work that was done in a process of its own.
struct Outcome {
  std::string result;  ///< what the work returned
  std::string fate;    ///< what ended it before that, such as "aborts"; empty where nothing did
  std::string said;    ///< all that it printed
};

/// Does the work in a process of its own, so that whoever crashes there or hangs ends nothing else.
/// limit: seconds of processor time.
Outcome doneApart(const std::function<std::string()>& work, int limit);

}  // namespace rigid_body_sim::extremes
