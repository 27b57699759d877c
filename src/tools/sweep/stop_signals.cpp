#include "tools/sweep/stop_signals.hpp"

#include <array>
#include <csignal>

namespace rigid_body_sim {
namespace {

constexpr std::array<int, 2> kSignals = {SIGINT, SIGTERM};

std::atomic<bool> stop_requested{false};
std::atomic<int> stop_signal{0};

extern "C" void keepForLater(int signal) {
  stop_signal = signal;
  stop_requested = true;
}

void setHandler(void (*handler)(int), int flags) {
  struct sigaction now {
  }, before{};
  now.sa_handler = handler;
  now.sa_flags = flags;
  for (const int signal : kSignals) {
    sigaction(signal, nullptr, &before);
    // a script's background jobs ignore interrupts, and so do we then
    if (before.sa_handler != SIG_IGN) sigaction(signal, &now, nullptr);
  }
}

}  // namespace

StopSignals::StopSignals() {
  static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<int>::is_always_lock_free,
                "a signal handler may touch nothing else");
  setHandler(keepForLater, SA_RESETHAND | SA_RESTART);
}

StopSignals::~StopSignals() { setHandler(SIG_DFL, 0); }

const std::atomic<bool>& StopSignals::requested() const { return stop_requested; }

void StopSignals::endIfRequested() const {
  if (!stop_requested) return;
  std::signal(stop_signal, SIG_DFL);
  std::raise(stop_signal);
}

}  // namespace rigid_body_sim
