#include "tools/common/slow_run_notice.hpp"

#include <algorithm>
#include <vector>

#include "math/shortest.hpp"
#include "programs/formatted.hpp"

namespace rigid_body_sim {
namespace {

struct FastestBody {
  std::string name;
  double rate = -1;  // [rad/s], [1/s]
};

FastestBody fastestBody(const Simulation& simulation) {
  const World& world = simulation.world();
  const State state = simulation.state();
  FastestBody fastest;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    if (!moves(world.bodies[i])) continue;
    const double w = toBodyFrameMotion(world.bodies[i], state.bodies[i]).w_W.norm();
    if (w > fastest.rate) fastest = {world.bodies[i].name, w};
  }
  return fastest;
}

/// The body that drag slows down fastest.
FastestBody mostDraggedBody(const Simulation& simulation) {
  const World& world = simulation.world();
  const State state = simulation.state();
  std::vector<const Body*> bodies;
  std::vector<double> speeds;  // [m/s]
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Body& body = world.bodies[i];
    bodies.push_back(&body);
    speeds.push_back(moves(body) ? stableNorm(state.bodies[i].p_W) / body.mass : 0);
  }
  FastestBody fastest;
  const double* own = state.laws.data();
  for (const auto& law : world.laws) {
    if (law->isOfMedium()) {
      const std::size_t body = law->members().front();
      std::vector<Stiffness> stiffness(bodies.size());
      law->addStiffness(bodies, stiffness);
      const double rate =
          std::max(stiffness[body].decay, law->rate({bodies, state.bodies, own}, speeds));
      if (rate > fastest.rate) fastest = {world.bodies[body].name, rate};
    }
    own += law->stateCount();
  }
  return fastest;
}

bool isSolved(const Simulation& simulation) {
  const std::vector<MotionPlan> plans = simulation.plans();
  return std::all_of(plans.begin(), plans.end(),
                     [](const MotionPlan& plan) { return plan.integrator.empty(); });
}

std::string reasonOf(const Simulation& simulation, double t_end) {
  const FastestBody fastest = fastestBody(simulation);
  const std::string turns =
      formatted("'%s' turns fastest, at %.3g rad/s", fastest.name.c_str(), fastest.rate);
  const double h = simulation.world().solver.time_step;
  if (simulation.maxSubsteps() > 1)
    return formatted("steps are divided into up to %d substeps to follow the motion (%s)",
                     simulation.maxSubsteps(), turns.c_str());
  const bool solved = isSolved(simulation);
  const FastestBody dragged = solved ? mostDraggedBody(simulation) : FastestBody();
  if (dragged.rate > fastest.rate && dragged.rate * h > 1)
    return formatted(
        "the motion is solved by series that are as short as drag is strong (it slows '%s' down at "
        "%.3g/s); weaker drag makes that cheaper",
        dragged.name.c_str(), dragged.rate);
  if (solved && fastest.rate * h > 1)
    return formatted(
        "the motion is solved radian by radian (%s); a stated tolerance makes that "
        "cheaper",
        turns.c_str());
  constexpr double kMany = 1000;
  if (!(t_end > kMany * h))
    return "each of its steps of " + shortest(h) +
           " s takes long, or the processor is busy; fewer bodies that move or a looser tolerance "
           "make them cheaper";
  return "it takes many steps of " + shortest(h) + " s; a longer time_step takes fewer";
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
  return formatted("after %.0f s the run has come to %.4g of %.4g s: ", elapsed, simulation.time(),
                   t_end_) +
         reasonOf(simulation, t_end_);
}

}  // namespace rigid_body_sim
