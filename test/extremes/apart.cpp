#include "apart.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace rigid_body_sim::extremes {
namespace {

constexpr int kReturned = 0, kThrew = 1;

std::string contentsOf(int file) {
  std::string contents;
  std::array<char, 4096> part{};
  lseek(file, 0, SEEK_SET);
  for (ssize_t size = 0; (size = read(file, part.data(), part.size())) > 0;)
    contents.append(part.data(), static_cast<std::size_t>(size));
  return contents;
}

void writeTo(int file, const std::string& text) {
  if (write(file, text.data(), text.size()) != static_cast<ssize_t>(text.size())) std::abort();
}

/// Processor time ends what is slow, and wall time what waits for ever.
void limitTo(int seconds) {
  const rlimit time{static_cast<rlim_t>(seconds), static_cast<rlim_t>(seconds) + 1};
  setrlimit(RLIMIT_CPU, &time);
  alarm(static_cast<unsigned>(10 * seconds));
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
}

[[noreturn]] void doAndExit(const std::function<std::string()>& work, int limit, int result,
                            int said) {
  dup2(said, STDOUT_FILENO);
  dup2(said, STDERR_FILENO);
  limitTo(limit);
  try {
    writeTo(result, work());
  } catch (const std::exception& failed) {
    writeTo(said, std::string(failed.what()) + "\n");
    _exit(kThrew);
  }
  _exit(kReturned);
}

std::string fateOf(int status, int limit) {
  if (WIFEXITED(status)) return WEXITSTATUS(status) == kThrew ? "throws" : "exits";
  const int signal = WTERMSIG(status);
  if (signal == SIGXCPU || signal == SIGKILL) return "over " + std::to_string(limit) + " s";
  if (signal == SIGALRM) return "hangs";
  return signal == SIGABRT ? "aborts" : "crashes";
}

struct TemporaryFile {
  std::FILE* file = std::tmpfile();
  ~TemporaryFile() {
    if (file) std::fclose(file);
  }
};

}  // namespace

Outcome doneApart(const std::function<std::string()>& work, int limit) {
  const TemporaryFile result, said;
  std::fflush(nullptr);  // or the child would print again what is still to be printed
  const pid_t child = result.file && said.file ? fork() : -1;
  if (child < 0) throw std::runtime_error("no process of its own to be had");
  if (child == 0) doAndExit(work, limit, fileno(result.file), fileno(said.file));
  int status = 0;
  waitpid(child, &status, 0);
  Outcome outcome;
  outcome.result = contentsOf(fileno(result.file));
  outcome.said = contentsOf(fileno(said.file));
  const bool returned = WIFEXITED(status) && WEXITSTATUS(status) == kReturned;
  if (!returned || outcome.result.empty()) outcome.fate = fateOf(status, limit);
  return outcome;
}

}  // namespace rigid_body_sim::extremes
