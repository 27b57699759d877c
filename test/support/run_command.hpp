#pragma once

#include <cstdio>
#include <string>

#include <sys/wait.h>

namespace rigid_body_sim::test {

/// How a program ended.
struct Outcome {
  int exit_code = -1;
  std::string out;  ///< what it wrote to standard output
};

/// Runs a command line of the shell to its end.
inline Outcome runCommand(const std::string& command) {
  std::FILE* pipe = popen(command.c_str(), "r");
  Outcome outcome;
  char buffer[4096];
  for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;)
    outcome.out.append(buffer, n);
  outcome.exit_code = WEXITSTATUS(pclose(pipe));
  return outcome;
}

}  // namespace rigid_body_sim::test
