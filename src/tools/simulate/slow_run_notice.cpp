#include "tools/simulate/slow_run_notice.hpp"

#include <algorithm>

#include "math/shortest.hpp"
#include "programs/formatted.hpp"

namespace rigid_body_sim {
namespace {

/// The body that turns fastest now, and how fast.
std::string fastestBody(const Simulation& simulation) {
  const World& world = simulation.world();
  const State state = simulation.state();
  std::size_t fastest = 0;
  double rate = -1;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (world.bodies[i].fixed) continue;
    const double w = toBodyFrameMotion(world.bodies[i], state.bodies[i]).w_W.norm();
    if (w > rate) fastest = i, rate = w;
  }
  return formatted("'%s' turns fastest, at %.3g rad/s", world.bodies[fastest].name.c_str(), rate);
}

std::string reasonOf(const Simulation& simulation) {
  if (simulation.maxSubsteps() > 1)
    return formatted("steps are divided into up to %d substeps to follow the motion (%s)",
                     simulation.maxSubsteps(), fastestBody(simulation).c_str());
  return formatted("it takes many steps of %s s; a longer time_step takes fewer (%s)",
                   shortest(simulation.world().solver.time_step).c_str(),
                   fastestBody(simulation).c_str());
}

}  // namespace

std::string SlowRunNotice::textIfDue(const Simulation& simulation) {
  constexpr double kLookEvery = 0.1;  // [s]
  if (is_said_ || simulation.steps() < next_look_) return "";
  const double elapsed =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  const auto steps = static_cast<double>(simulation.steps());
  next_look_ =
      simulation.steps() + static_cast<std::int64_t>(std::clamp(
                               steps * kLookEvery / std::max(elapsed, kLookEvery), 1.0, 1e6));
  if (elapsed < patience_) return "";
  is_said_ = true;
  return formatted("%.0f s of computing have reached %.4g of %.4g s: ", elapsed, simulation.time(),
                   t_end_) +
         reasonOf(simulation);
}

}  // namespace rigid_body_sim
