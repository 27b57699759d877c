#include "tools/sweep/stop_signals.hpp"

#include <array>
#include <csignal>
#include <cstring>
#include <utility>

#include <unistd.h>

namespace rigid_body_sim {
namespace {

constexpr std::array<int, 3> kSignals = {SIGINT, SIGTERM, SIGHUP};

std::atomic<bool> stop_requested{false};
std::atomic<int> stop_signal{0};
std::atomic<const char*> last_words{nullptr};

extern "C" void keepForLater(int signal) {
  stop_signal = signal;
  stop_requested = true;
}

/// Calls nothing but what a handler may.
extern "C" void sayAndEnd(int signal) {
  const char* const line = last_words;
  const ssize_t said = write(STDERR_FILENO, line, std::strlen(line));
  static_cast<void>(said);  // to whom else
  std::signal(signal, SIG_DFL);
  std::raise(signal);
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
  static_assert(std::atomic<const char*>::is_always_lock_free, "nor may the other one");
  setHandler(keepForLater, SA_RESETHAND | SA_RESTART);
}

StopSignals::~StopSignals() {
  setHandler(SIG_DFL, 0);
  last_words = nullptr;
}

void StopSignals::endAtOnce(std::string line) {
  last_words_ = std::move(line);
  last_words = last_words_.c_str();
  setHandler(sayAndEnd, SA_RESETHAND);
  if (stop_requested) sayAndEnd(stop_signal);
}

const std::atomic<bool>& StopSignals::requested() const { return stop_requested; }

void StopSignals::endIfRequested() const {
  if (!stop_requested) return;
  std::signal(stop_signal, SIG_DFL);
  std::raise(stop_signal);
}

}  // namespace rigid_body_sim
