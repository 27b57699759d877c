#pragma once

namespace rigid_body_sim {

/// A bar on standard error while it is a terminal; otherwise nothing.
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
  int percent_ = -1;
};

}  // namespace rigid_body_sim
