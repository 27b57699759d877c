// Draws a run: motion, energy and momentum balance, and forces over time.
#include <cstdio>
#include <sstream>
#include <string>
#include <vector>

#include "programs/distinct_files.hpp"
#include "programs/run_program.hpp"
#include "programs/standard_streams.hpp"
#include "programs/tool_scene.hpp"
#include "programs/usage.hpp"
#include "tools/common/gnuplot.hpp"
#include "tools/plot/plot_run.hpp"

namespace rigid_body_sim {
namespace {

const char* const kHelp = R"(usage: plot FILE ... [options]
Draws a run over time, as SVG pictures: position, attitude, velocity and angular velocity; forces and
torques; energy and momentum, and the part of them that work and impulses do not account for. FILE is
  a bag (.bag), recorded from a node or written by simulate --bag. Motion is read from the odometry
    of the bodies, forces from <body>/applied_wrench, <body>/pivot_force and ~contacts, energy and
    momentum from ~status: whatever of these the bag holds; or
  one or more CSV files (any other name) of one run of simulate: of its motion, from --csv or --plot;
    of its forces and of its balance, from --plot.

  --out DIR       where the pictures go, made if absent; default: here
  --bodies A,B    the bodies to draw; default: those that move, eight at most
  --help          this text

Roll, pitch and yaw go on without jumps: pitch beyond a quarter of a turn, all of them beyond a turn.
After an absence and where the body was put into another attitude they begin anew. Forces that are zero
throughout are not drawn. Of several runs in a bag, separated by resets of time or by loads, the last
is drawn. Stamps of a bag that are wall time count from the first one on. Needs gnuplot:
apt install gnuplot-nox.
Exit status: 0 done; 1 a file cannot be read or written, or gnuplot is missing; 2 wrong usage.
)";

std::vector<std::string> namesIn(const std::string& list) {
  std::vector<std::string> names;
  std::istringstream stream(list);
  for (std::string name; std::getline(stream, name, ',');) names.push_back(name);
  if (names.empty()) throw UsageError("--bodies: names separated by commas are needed");
  return names;
}

void run(const PlotJob& job) {
  if (!hasGnuplot()) throw std::runtime_error(gnuplotIsMissing(job.files[0] + " is there"));
  const auto note = [](const std::string& text) {
    std::fprintf(stderr, "%s\n", noticeLine("plot", text).c_str());
  };
  print(plotRun(job, note) + "\n");
}

}  // namespace
}  // namespace rigid_body_sim

int main(int argc, char** argv) {
  using namespace rigid_body_sim;
  return runProgram("plot", [&] {
    PlotJob job;
    const OptionActions actions{
        {"out", [&](const char* s) { job.out = pictureDirectory("--out", s); }},
        {"bodies", [&](const char* s) { job.bodies = namesIn(s); }}};
    const auto files =
        readCommandLine(argc, argv, actions, "at least one file is", kAtLeastOne, {});
    job.files = files.value_or(std::vector<std::string>());
    if (files)
      run(job);
    else
      print(kHelp);
  });
}
