#pragma once

#include "programs/looking_thread.hpp"

namespace rigid_body_sim {

/// Ends the process where a shutdown finds it computing: a step, or the trials of auto before the
/// first, may take minutes, and ask nobody. Nothing is lost by it: what is published then reaches
/// nobody, and no file is replaced before it is whole.
class ShutdownWatch {
 public:
  ShutdownWatch();

 private:
  bool look();

  int begun_ = 0, done_ = 0;  // looks at which roscpp's shutdown was, by the thread
  LookingThread thread_;      // the last: it sees the others
};

}  // namespace rigid_body_sim
