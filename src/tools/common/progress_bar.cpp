#include "tools/common/progress_bar.hpp"

#include <cstdio>
#include <string>

#include <unistd.h>

namespace rigid_body_sim {

ProgressBar::ProgressBar() : on_terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressBar::~ProgressBar() {
  if (percent_ >= 0) std::fputs("\r\033[K", stderr);
}

void ProgressBar::show(double done) {
  if (!on_terminal_) return;
  const int percent = static_cast<int>(100 * done);
  if (percent == percent_) return;
  percent_ = percent;
  const auto filled = static_cast<std::size_t>(percent / 2);
  const std::string bar = std::string(filled, '#') + std::string(50 - filled, ' ');
  std::fprintf(stderr, "\r[%s] %3d %%", bar.c_str(), percent);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
  if (done > 0) std::fprintf(stderr, ", %.0f s left\033[K", elapsed.count() * (1 - done) / done);
}

}  // namespace rigid_body_sim
