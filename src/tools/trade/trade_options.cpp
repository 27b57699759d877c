#include "tools/trade/trade_options.hpp"

#include "programs/usage.hpp"
#include "tools/common/gnuplot.hpp"

namespace rigid_body_sim {

TradeOptions parseTradeOptions(int argc, char** argv) {
  TradeOptions options;
  const OptionActions actions{
      numberInto(options.duration, "duration"),
      numberInto(options.error_budget, "error-budget"),
      {"out", [&](const char* s) { options.out = pictureDirectory("--out", s); }}};
  const auto scene =
      readCommandLine(argc, argv, actions, "scene file", {{"write", &options.write}});
  options.help = !scene;
  options.scene = scene.value_or("");
  return options;
}

std::string tradeHelp() {
  return R"(usage: trade SCENE [options]
Measures what accuracy costs on a scene: runs it with every integrator that supports it, over a ladder
of time steps, against a reference that two independent methods agree on. Prints the table and the
setting that does the least work within the error budget, as keys to replace in the scene. With
contact the scene is run under auto over a ladder of tolerances; the reference is auto at 1e-10, and two
more runs show its error, and until when the motion can be known at all.

  --duration S      simulated time [s]; default: the scene's horizon
  --error-budget X  bound on the attitude error [rad] and on the position error relative to the
                    path; default: the scene's tolerance
  --out DIR         where trade.csv and trade.svg go, made if absent; default: here
  --write           replaces these keys in the scene file and keeps everything else in it; with an
                    integrator other than auto, tolerance becomes a comment
  --help            this text

CSV columns: integrator,time_step,attitude_error,position_error,energy_error,
angular_momentum_error,cpu_ns_per_sim_s,force_evaluations and, with contact, tolerance. Errors are the
worst of all bodies and instants: attitude [rad]; position relative to the path; energy of all bodies
relative to their greatest kinetic energy; angular momentum relative to its greatest. Processor time is
that of the steps, in nanoseconds per simulated second; evaluations are those of the whole run. Rows are
written as they are measured, so an interrupted run leaves a valid file. The plot needs gnuplot.

Work is counted, in evaluations weighted by what a step of each integrator costs, and not timed, so
that the same scene gives the same advice every time. Of settings that do equal work, as where a
motion is solved whatever the step, the scene's integrator and step come first, then short steps.
A node applies messages at time steps: for that reason a shorter step than the recommended one may
be wanted. A shorter one costs more and is at least as accurate.
Exit status: 0 done, 1 the input is at fault, 2 wrong usage, 3 the simulation diverged.
)";
}

}  // namespace rigid_body_sim
