#include "trade_options.hpp"

#include <getopt.h>

#include "usage.hpp"

namespace rigid_body_sim {

TradeOptions parseTradeOptions(int argc, char** argv) {
  static const option known[] = {{"duration", required_argument, nullptr, 'd'},
                                 {"error-budget", required_argument, nullptr, 'e'},
                                 {"out", required_argument, nullptr, 'o'},
                                 {"help", no_argument, nullptr, 'h'},
                                 {nullptr, 0, nullptr, 0}};
  TradeOptions options;
  opterr = 0;  // the message below is ours
  for (int code; (code = getopt_long(argc, argv, ":h", known, nullptr)) != -1;) {
    switch (code) {
      case 'd':
        options.duration = positiveNumber("duration", optarg);
        break;
      case 'e':
        options.error_budget = positiveNumber("error-budget", optarg);
        break;
      case 'o':
        options.out = optarg;
        break;
      case 'h':
        options.help = true;
        break;
      case ':':
        throw UsageError(std::string(argv[optind - 1]) + " needs a value");
      default:
        throw UsageError("unknown option " + std::string(argv[optind - 1]));
    }
  }
  if (options.help) return options;
  if (optind + 1 != argc)
    throw UsageError("exactly one scene file is needed, got " + std::to_string(argc - optind));
  options.scene = argv[optind];
  return options;
}

std::string tradeHelp() {
  return R"(usage: trade SCENE [options]
Measures what accuracy costs on a scene: runs it with every integrator that takes it, over a ladder
of time steps, against a reference that two independent methods agree on. Prints the table and the
cheapest setting within the error budget, as two lines to paste into the scene.

  --duration S      simulated time [s]; default: the scene's horizon
  --error-budget X  bound on the attitude error [rad] and on the position error relative to the
                    path; default: the scene's tolerance
  --out DIR         where trade.csv and trade.svg go, made if absent; default: here
  --help            this text

CSV columns: integrator,time_step,attitude_error,position_error,energy_error,
angular_momentum_error,cpu_ns_per_sim_s,force_evaluations. Errors are the worst of all bodies and
instants: attitude [rad]; position relative to the path; energy of all bodies relative to their
greatest kinetic energy; angular momentum relative to its greatest. Processor time is that of the
steps, in nanoseconds per simulated second; evaluations are those of the whole run. Rows are written
as they are measured, so an interrupted run leaves a valid file. The plot needs gnuplot.

A node takes messages over and publishes at time steps: for that reason a shorter step than the
cheapest may be wanted. A shorter one is at least as accurate.
Exit status: 0 done, 1 the input is at fault, 2 wrong usage, 3 the simulation diverged.
)";
}

}  // namespace rigid_body_sim
