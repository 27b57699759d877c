#include <algorithm>
#include <stdexcept>

#include <rigid_body_sim/dynamics/line_force.hpp>
#include <rigid_body_sim/dynamics/tether.hpp>
#include <rigid_body_sim/dynamics/world.hpp>

#include "dynamics/laws/line.hpp"
#include "dynamics/state_of_world.hpp"

namespace rigid_body_sim {
namespace {

LineForce::End reportedEnd(const Spring::End& end, const ForceLaw::Bodies& at) {
  const std::array<Vector3d, 2> origin = originOf(end, at);
  return {end.body, origin[0] + (origin[1] + armOf(end, at))};
}

/// Of a spring or a tether.
template <class Law>
LineForce lineForceOf(const Law& law, const ForceLaw::Bodies& at) {
  LineForce line;
  line.from = reportedEnd(law.ends()[0], at);
  line.to = reportedEnd(law.ends()[1], at);
  line.length = gapBetween(law.ends(), at).norm();
  line.tension = law.tension(at);
  return line;
}

void addLineForce(const ForceLaw& law, std::size_t index, const ForceLaw::Bodies& at,
                  std::vector<LineForce>& lines) {
  LineForce line;
  if (const auto* spring = dynamic_cast<const Spring*>(&law)) {
    line = lineForceOf(*spring, at);
  } else if (const auto* tether = dynamic_cast<const Tether*>(&law)) {
    line = lineForceOf(*tether, at);
    line.is_slack = !tether->isTaut(at.own);
  } else {
    return;
  }
  line.law = index;
  lines.push_back(line);
}

}  // namespace

bool hasLines(const World& world) {
  return std::any_of(world.laws.begin(), world.laws.end(), [](const auto& law) {
    return dynamic_cast<const Spring*>(law.get()) || dynamic_cast<const Tether*>(law.get());
  });
}

std::vector<LineForce> lineForcesOf(const World& world, const State& state) {
  requireStateOf(world, state);
  const auto hasStates = [](const auto& law) { return law->stateCount() > 0; };
  if (state.laws.empty() && std::any_of(world.laws.begin(), world.laws.end(), hasStates))
    throw std::invalid_argument(
        "the state lacks those of the laws of the world: take one that a simulation gave");
  std::vector<const Body*> bodies;
  for (const Body& body : world.bodies) bodies.push_back(&body);
  std::vector<LineForce> lines;
  const double* own = state.laws.data();
  for (std::size_t i = 0; i < world.laws.size(); ++i) {
    addLineForce(*world.laws[i], i, {bodies, state.bodies, own}, lines);
    own += world.laws[i]->stateCount();
  }
  return lines;
}

}  // namespace rigid_body_sim
