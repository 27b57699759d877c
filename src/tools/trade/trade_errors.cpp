#include "tools/trade/trade_errors.hpp"

#include <cmath>
#include <limits>

#include "dynamics/run/position_rounding.hpp"

namespace rigid_body_sim {
namespace {

/// Takes in one more error; one that is no number is infinite.
void raise(double& worst, double error) {
  worst = std::max(worst, std::isnan(error) ? std::numeric_limits<double>::infinity() : error);
}

double relative(double difference, double scale) {
  return scale > 0 ? difference / scale : difference;
}

/// rounding [m]: of the body's place.
void addErrorsOfBody(std::size_t body, double rounding, const std::vector<State>& track,
                     const std::vector<State>& truth, Errors& worst) {
  double L_scale = 0;
  for (const State& state : truth) L_scale = std::max(L_scale, state.bodies[body].L_W.norm());
  double path = 0;
  for (std::size_t k = 1; k < truth.size(); ++k) {
    const BodyState& a = track[k].bodies[body];
    const BodyState& b = truth[k].bodies[body];
    path += distanceBetween(b, truth[k - 1].bodies[body]);
    raise(worst.attitude, angleBetween(a.q_WP, b.q_WP));
    raise(worst.position, relative(std::max(0.0, distanceBetween(a, b) - rounding), path));
    raise(worst.angular_momentum, relative((a.L_W - b.L_W).norm(), L_scale));
  }
}

double kineticEnergyOfAll(const World& world, const State& state) {
  double sum = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
    if (!world.bodies[i].fixed) sum += kineticEnergy(world.bodies[i], state.bodies[i]);
  return sum;
}

}  // namespace

Errors errorsOf(const World& world, const std::vector<State>& track,
                const std::vector<State>& truth) {
  Errors worst;
  const std::vector<double> rounding = positionRounding(world, truth.front().bodies, {});
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
    if (!world.bodies[i].fixed) addErrorsOfBody(i, rounding[i], track, truth, worst);
  double scale = 0;
  for (const State& state : truth) scale = std::max(scale, kineticEnergyOfAll(world, state));
  for (std::size_t k = 1; k < truth.size(); ++k)
    raise(worst.energy,
          relative(std::abs(mechanicalEnergy(world, track[k]) - mechanicalEnergy(world, truth[k])),
                   scale));
  return worst;
}

}  // namespace rigid_body_sim
