// Compares two runs, instant by instant: bags of the node or of simulate, or CSV files of simulate.
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "programs/run_program.hpp"
#include "programs/standard_streams.hpp"
#include "programs/tool_scene.hpp"
#include "programs/usage.hpp"
#include "tools/common/csv_rows.hpp"
#include "tools/compare_runs/motion_difference.hpp"

namespace rigid_body_sim {
namespace {

const char* const kHelp = R"(usage: compare_runs FIRST SECOND [options]
Compares two runs at the instants that are in both, and prints the greatest differences of each body
that is in both. Both are
  bags (.bag): the odometry of the bodies, recorded from a node or written by simulate --bag; or
  CSV files (any other name) of simulate --csv.

  --tolerance X  differences up to X count as none: position [m], attitude [rad], velocity [m/s],
                 angular velocity [rad/s]; default: the bits must be the same, those of 0 and -0
                 or of q and -q are not
  --help         this text

A body of one run only is printed, and does not count as a difference. A record holds several states
of an instant where one was set while time stood: of these the nearest to the other run counts, and
the line of the body says of how many instants. Of several runs in a bag, separated by resets of time
or by loads, the last is compared.
Exit status: 0 the bodies of both runs agree; 1 they differ, or the input is at fault; 2 wrong usage.
)";

void compare(const std::vector<std::string>& files, double tolerance) {
  if (isBag(files[0]) != isBag(files[1]))
    throw UsageError("a bag and a CSV file cannot be compared: their velocities have other axes");
  bool agree = true, in_bits_alone = true;
  std::string report;
  const RecordedMotion first = readMotion(files[0]), second = readMotion(files[1]);
  for (const std::string& notice : {first.notice, second.notice})
    if (!notice.empty()) std::fprintf(stderr, "%s\n", noticeLine("compare_runs", notice).c_str());
  for (const MotionDifference& body : differencesOf(first, second)) {
    report += text(body);
    agree &= body.isWithin(tolerance);
    in_bits_alone &= body.same_bits || body.isOfBitsAlone();
  }
  for (const std::string& body : bodiesOfOne(first, second))
    report += body + ": in one of the runs only, not compared\n";
  print(report);
  if (!agree && in_bits_alone)
    throw std::runtime_error("the runs differ in bits alone; --tolerance X compares their motion");
  if (!agree) throw std::runtime_error("the runs differ");
}

}  // namespace
}  // namespace rigid_body_sim

int main(int argc, char** argv) {
  using namespace rigid_body_sim;
  return runProgram("compare_runs", [&] {
    double tolerance = 0;
    const OptionActions actions{
        {"tolerance", [&](const char* s) { tolerance = positiveNumber("tolerance", s); }}};
    const auto files = readCommandLine(argc, argv, actions, "exactly two files are", 2, {});
    if (files)
      compare(*files, tolerance);
    else
      print(kHelp);
  });
}
