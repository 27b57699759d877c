#include "tools/common/slow_run_notice.hpp"

#include <algorithm>
#include <cmath>
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

/// What a law makes swing or slow down fastest: of all laws, or of those of a medium alone.
struct FastestLaw {
  std::string name, body;
  double rate = -1;  // [1/s]
};

FastestLaw fastestLaw(const Simulation& simulation, bool of_medium_only) {
  const World& world = simulation.world();
  const State state = simulation.state();
  std::vector<const Body*> bodies;
  std::vector<double> speeds;  // [m/s]
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Body& body = world.bodies[i];
    bodies.push_back(&body);
    speeds.push_back(moves(body) ? stableNorm(state.bodies[i].p_W) / body.mass : 0);
  }
  FastestLaw fastest;
  std::vector<Stiffness> stiffness(bodies.size());
  const double* own = state.laws.data();
  for (const auto& law : world.laws) {
    if (law->isOfMedium() || !of_medium_only) {
      law->addStiffness(bodies, stiffness);
      const double changes = law->rate({bodies, state.bodies, own}, speeds);
      for (const std::size_t body : law->members()) {
        const Stiffness of_body = stiffness[body];
        stiffness[body] = Stiffness();  // for the next law
        const double rate =
            std::max({changes, of_body.decay, std::sqrt(of_body.frequency_squared)});
        if (rate > fastest.rate) fastest = {law->name(), world.bodies[body].name, rate};
      }
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

/// " ('wheel' turns fastest, at 20 rad/s)", or what a law brings about where that is faster.
std::string whatIsDivided(const Simulation& simulation, const FastestBody& turning) {
  const FastestLaw law = fastestLaw(simulation, false);
  if (law.rate > turning.rate)
    return formatted(" (fastest is what %s makes '%s' swing or slow down by, at %.3g/s)",
                     law.name.c_str(), law.body.c_str(), law.rate);
  if (!(turning.rate > 0)) return "";
  return formatted(" ('%s' turns fastest, at %.3g rad/s)", turning.name.c_str(), turning.rate);
}

std::string reasonOf(const Simulation& simulation, double t_end) {
  const FastestBody fastest = fastestBody(simulation);
  const double h = simulation.world().solver.time_step;
  if (simulation.maxSubsteps() > 1)
    return formatted("steps are divided into up to %d substeps to follow the motion",
                     simulation.maxSubsteps()) +
           whatIsDivided(simulation, fastest);
  const bool solved = isSolved(simulation);
  const FastestLaw dragged = solved ? fastestLaw(simulation, true) : FastestLaw();
  if (dragged.rate > fastest.rate && dragged.rate * h > 1)
    return formatted(
        "the motion is solved by series that are as short as drag is strong (it slows '%s' down at "
        "%.3g/s); weaker drag makes that cheaper",
        dragged.body.c_str(), dragged.rate);
  if (solved && fastest.rate * h > 1)
    return formatted(
        "the motion is solved radian by radian ('%s' turns fastest, at %.3g rad/s); a stated "
        "tolerance makes that cheaper",
        fastest.name.c_str(), fastest.rate);
  constexpr double kMany = 1000;
  if (!(t_end > kMany * h))
    return "each of its steps of " + shortest(h) +
           " s takes long, or the processor is busy; fewer bodies that move or a looser tolerance "
           "make them cheaper";
  return "it takes many steps of " + shortest(h) + " s; a longer time_step takes fewer";
}

}  // namespace

/// By the pace of late: a run may become slower and slower.
void SlowRunNotice::planLook(std::int64_t steps, Clock::time_point now) {
  constexpr double kLookEvery = 0.1;  // [s]
  const double since = std::chrono::duration<double>(now - last_look_).count();
  const auto taken = static_cast<double>(steps - looked_at_);
  constexpr double kMaxGrowth = 10;
  const double pace = std::min(kLookEvery / std::max(since, 1e-9), kMaxGrowth);
  next_look_ = steps + static_cast<std::int64_t>(std::clamp(taken * pace, 1.0, 1e6));
  last_look_ = now;
  looked_at_ = steps;
}

std::string SlowRunNotice::textIfDue(const Simulation& simulation) {
  if (simulation.steps() < next_look_) return "";
  const Clock::time_point now = Clock::now();
  planLook(simulation.steps(), now);
  const double elapsed = std::chrono::duration<double>(now - begin_).count();
  if (is_said_ || elapsed < patience_) return "";
  is_said_ = true;
  return formatted("after %.0f s the run has come to %.4g of %.4g s: ", elapsed, simulation.time(),
                   t_end_) +
         reasonOf(simulation, t_end_);
}

}  // namespace rigid_body_sim
