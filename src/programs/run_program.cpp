#include "programs/run_program.hpp"

#include <cstdio>
#include <exception>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "programs/standard_streams.hpp"
#include "programs/usage.hpp"

namespace rigid_body_sim {

int runProgram(const std::string& name, const std::function<void()>& body) {
  try {
    reserveStandardStreams();
    failBeyondFileSize();
    body();
    return kDone;
  } catch (const UsageError& error) {
    std::fprintf(stderr, "%s: %s (%s --help)\n", name.c_str(), error.what(), name.c_str());
    return kWrongUsage;
  } catch (const SimulationDiverged& error) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
    return kDiverged;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", name.c_str(), error.what());
    return kBadInput;
  }
}

int printHelp(const std::string& name, const std::string& text) {
  return runProgram(name, [&] { print(text); });
}

}  // namespace rigid_body_sim
