#include "tools/simulate/plot_files.hpp"

#include <filesystem>

#include <rigid_body_sim/dynamics/acceleration.hpp>

#include "dynamics/run/coupling.hpp"
#include "programs/make_directory.hpp"
#include "tools/common/csv_header.hpp"

namespace rigid_body_sim {
namespace {

const std::string& made(const std::string& directory) {
  makeDirectory(directory);
  return directory;
}

void print(std::FILE* out, const Vector3d& v) {
  std::fprintf(out, ",%.17g,%.17g,%.17g", v.x(), v.y(), v.z());
}

/// All forces but uniform gravity.
Vector3d forceOn(const Body& body, const BodyMotion& motion, const Vector3d& g_W) {
  return body.mass * (accelerationOf(body, motion, body.com_P) - g_W);
}

/// I ω' + ω × I ω, which is what acts on the body apart from its wheels and rotors.
Vector3d torqueOn(const Body& body, const BodyMotion& motion) {
  constexpr double kRounding = 1e-12;  // of a body that turns freely nothing else is left
  const Vector3d& L_P = motion.state.L_P;
  const Vector3d gyroscopic = angularVelocity(body.inv_I, L_P).cross(L_P);
  const Vector3d torque = body.I.cwiseProduct(motion.acceleration.w_dot_P) + gyroscopic;
  if (torque.norm() <= kRounding * gyroscopic.norm()) return Vector3d::Zero();
  return rotate(motion.state.q_WP, torque);
}

}  // namespace

std::vector<std::string> PlotFiles::pathsIn(const std::string& directory) {
  const std::filesystem::path in = directory;
  return {(in / "motion.csv").string(), (in / "forces.csv").string(),
          (in / "balance.csv").string()};
}

PlotFiles::PlotFiles(const std::string& directory, Simulation& simulation)
    : simulation_(simulation),
      motion_(pathsIn(made(directory))[0]),
      forces_(pathsIn(directory)[1], kForcesHeader),
      balance_(pathsIn(directory)[2], kBalanceHeader) {
  simulation.trackBalance();
  finish();  // the headers: a file that takes nothing is reported before the run
}

void PlotFiles::write(const State& state) {
  motion_.write(simulation_.world(), state);
  writeForces(state);
  if (balanced_steps_ != simulation_.steps()) writeBalance();
}

void PlotFiles::writeForces(const State& state) {
  const World& world = simulation_.world();
  const std::vector<std::size_t> moving = movingBodies(world);
  const std::vector<BodyMotion> motions = simulation_.motions(moving, state.t);
  for (std::size_t k = 0; k < moving.size(); ++k) {
    const Body& body = world.bodies[moving[k]];
    std::fprintf(forces_.stream(), "%.17g,%s", state.t, body.name.c_str());
    print(forces_.stream(), forceOn(body, motions[k], world.g_W));
    print(forces_.stream(), torqueOn(body, motions[k]));
    std::fputc('\n', forces_.stream());
  }
  forces_.check();
}

void PlotFiles::writeBalance() {
  balanced_steps_ = simulation_.steps();
  const World& world = simulation_.world();
  const State state = simulation_.state();
  double kinetic = 0;
  for (const std::size_t i : movingBodies(world))
    kinetic += kineticEnergy(world.bodies[i], state.bodies[i]);
  const Totals has = totalsOf(world, state), left = simulation_.balance();
  std::fprintf(balance_.stream(), "%.17g,%.17g,%.17g,%.17g", state.t, has.energy, kinetic,
               simulation_.exchanged().energy);
  print(balance_.stream(), has.momentum);
  print(balance_.stream(), has.angular_momentum);
  std::fprintf(balance_.stream(), ",%.17g", left.energy);
  print(balance_.stream(), left.momentum);
  print(balance_.stream(), left.angular_momentum);
  std::fputc('\n', balance_.stream());
  balance_.check();
}

void PlotFiles::finish() {
  motion_.finish();
  forces_.finish();
  balance_.finish();
}

}  // namespace rigid_body_sim
