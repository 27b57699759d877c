#include "tools/simulate/simulate_options.hpp"

#include <stdexcept>

#include <rigid_body_sim/dynamics/world.hpp>

#include "dynamics/methods/catalogue.hpp"
#include "programs/usage.hpp"
#include "tools/common/gnuplot.hpp"

namespace rigid_body_sim {
namespace {

std::string integratorNamed(const std::string& name) {
  try {
    if (name != "auto") methodNamed(name);
  } catch (const std::invalid_argument& unknown) {
    throw UsageError(std::string("--") + unknown.what());
  }
  return name;
}

}  // namespace

SimulateOptions parseSimulateOptions(int argc, char** argv) {
  SimulateOptions options;
  const OptionActions actions{
      numberInto(options.duration, "duration"),
      numberInto(options.sample, "sample"),
      numberInto(options.time_step, "time-step"),
      numberInto(options.tolerance, "tolerance"),
      {"integrator", [&](const char* s) { options.integrator = integratorNamed(s); }},
      {"threads",
       [&](const char* s) {
         options.threads =
             static_cast<int>(wholeNumber("threads", s, 1, SolverOptions::kMaxThreads));
       }},
      textInto(options.csv, "csv"),
      textInto(options.imu_csv, "imu-csv"),
      textInto(options.bag, "bag"),
      {"plot", [&](const char* s) { options.plot = pictureDirectory("--plot", s); }},
      textInto(options.wrench_bag, "wrench-bag"),
      textInto(options.save, "save"),
      textInto(options.load, "load")};
  const auto scene = readCommandLine(argc, argv, actions, "scene file");
  if (options.load && options.wrench_bag)
    throw UsageError(
        "--load and --wrench-bag exclude each other: the record of a run that went on from a state "
        "holds that state");
  options.help = !scene;
  options.scene = scene.value_or("");
  if (options.csv == "-" && options.imu_csv == "-")
    throw UsageError("--csv and --imu-csv cannot both be the standard output, -");
  return options;
}

std::string simulateHelp() {
  return R"(usage: simulate SCENE [options]
Integrates a scene offline, as fast as it can, and says where the bodies went and how well energy
and momentum were conserved, or what changed them.

  --duration S       simulated time [s]; default: the scene's horizon, or the length of the record
  --sample S         time between rows of the CSV and states of the bag [s]; default: the time
                     step in the CSV, 0.01 in the bag
  --integrator NAME  in place of the scene's
  --time-step S      in place of the scene's [s]
  --tolerance X      in place of the scene's, with integrator auto only
  --threads N        in place of the scene's: at most so many step and read many bodies
  --csv FILE|-       a row for each body and sample; - is the standard output
  --imu-csv FILE|-   a row for each sample of each IMU of the scene, at the IMU's own rate and
                     without noise
  --bag FILE         the topics on the bodies that a node with publish_clock publishes, stamped from
                     zero on, or as the recorded run; without ~inputs, and without ~status and
                     /diagnostics, which report wall time
  --plot DIR         pictures of the run: motion, forces, energy and momentum balance over time, as
                     SVG; and motion.csv, forces.csv, balance.csv, of which plot draws them anew
  --wrench-bag FILE  repeats the last run in the recorded topic ~inputs of a node, to the last bit;
                     from a bag without that topic, applies its messages on wrenches and commands at
                     their times in the bag
  --save FILE        the whole state at the end, which must be at a step
  --load FILE        goes on from a saved state: a run cut in two gives the same bits as in one.
                     Time goes on; --duration counts from there
  --help             this text

CSV columns: time,body,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz: position of the body frame's origin
[m], attitude, velocity of that origin [m/s] and angular velocity [rad/s], all in world axes.
IMU columns: time,body,imu,gx,gy,gz,ax,ay,az: angular velocity [rad/s] and specific force [m/s^2] in
the axes of the IMU.
Files of --plot beside the CSV above, with a row for each sample:
forces.csv: time,body,fx,fy,fz,tx,ty,tz: force [N] on each body that moves, all but uniform gravity,
and torque [N m] about its centre of mass, or its pivot; world axes.
balance.csv: of all bodies together energy [J], kinetic energy in it, work done, momentum [kg m/s],
angular momentum [kg m^2/s] about the origin; *_balance: what work and impulses leave unaccounted for.
Exit status: 0 done, 1 the input is at fault, 2 wrong usage, 3 the simulation diverged.
)";
}

}  // namespace rigid_body_sim
