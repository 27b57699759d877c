#include "dynamics/run/position_rounding.hpp"

#include <limits>

#include "dynamics/run/coupling.hpp"

namespace rigid_body_sim {

std::vector<double> positionRounding(const World& world, const std::vector<BodyState>& states,
                                     const std::vector<double>& law_states) {
  constexpr double kFactor = 4 * std::numeric_limits<double>::epsilon();
  std::vector<const Body*> bodies;
  std::vector<double> rounding;
  for (const Body& body : world.bodies) {
    bodies.push_back(&body);
    rounding.push_back(!moves(body) ? 0 : kFactor * radiusOfGyration(body));
  }
  const LawTable table(world);
  const std::vector<double> own = law_states.empty() ? table.start(world) : law_states;
  for (std::size_t i = 0; i < world.laws.size(); ++i) {
    const double reach = world.laws[i]->reach({bodies, states, own.data() + table.firstState(i)});
    for (std::size_t body : world.laws[i]->members()) rounding[body] += kFactor * reach;
  }
  return rounding;
}

}  // namespace rigid_body_sim
