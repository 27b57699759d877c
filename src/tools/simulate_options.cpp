#include "simulate_options.hpp"

#include <getopt.h>

#include "usage.hpp"

namespace rigid_body_sim {
SimulateOptions parseSimulateOptions(int argc, char** argv) {
  static const option known[] = {{"duration", required_argument, nullptr, 'd'},
                                 {"sample", required_argument, nullptr, 's'},
                                 {"time-step", required_argument, nullptr, 't'},
                                 {"tolerance", required_argument, nullptr, 'e'},
                                 {"integrator", required_argument, nullptr, 'i'},
                                 {"csv", required_argument, nullptr, 'c'},
                                 {"help", no_argument, nullptr, 'h'},
                                 {nullptr, 0, nullptr, 0}};
  SimulateOptions options;
  opterr = 0;  // the message below is ours
  for (int code; (code = getopt_long(argc, argv, ":h", known, nullptr)) != -1;) {
    switch (code) {
      case 'd':
        options.duration = positiveNumber("duration", optarg);
        break;
      case 's':
        options.sample = positiveNumber("sample", optarg);
        break;
      case 't':
        options.time_step = positiveNumber("time-step", optarg);
        break;
      case 'e':
        options.tolerance = positiveNumber("tolerance", optarg);
        break;
      case 'i':
        options.integrator = optarg;
        break;
      case 'c':
        options.csv = optarg;
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

std::string simulateHelp() {
  return R"(usage: simulate SCENE [options]
Integrates a scene offline, as fast as it can, and says where the bodies went and how well energy
and momentum were kept.

  --duration S       simulated time [s]; default: the scene's horizon
  --sample S         time between rows of the CSV [s]; default: the time step
  --integrator NAME  in place of the scene's
  --time-step S      in place of the scene's [s]
  --tolerance X      in place of the scene's, for integrator auto
  --csv FILE|-       a row for each body and sample; - is the standard output
  --help             this text

CSV columns: time,body,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz: position of the body frame's origin
[m], attitude, velocity of that origin [m/s] and angular velocity [rad/s], all in world axes.
Exit status: 0 done, 1 the input is at fault, 2 wrong usage, 3 the simulation diverged.
)";
}

}  // namespace rigid_body_sim
