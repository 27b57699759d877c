#pragma once

#include <chrono>

namespace rigid_body_sim {

/// A bar on standard error while it is a terminal, with the time left; otherwise nothing.
class ProgressBar {
 public:
  ProgressBar();
  /// Wipes the bar.
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// done: 0 … 1. Cheap to call often.
  void show(double done);

 private:
  bool on_terminal_;
  std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  int percent_ = -1;
};

}  // namespace rigid_body_sim
