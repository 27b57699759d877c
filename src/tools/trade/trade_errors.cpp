#include "tools/trade/trade_errors.hpp"

#include <cmath>
#include <limits>

#include "dynamics/run/position_rounding.hpp"

namespace rigid_body_sim {
namespace {

/// Takes in one more error; one that is no number is infinite.
void raise(double& worst, double error) {
  if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
  worst = std::max(worst, error);
}

double relative(double difference, double scale) {
  return scale > 0 ? difference / scale : difference;
}

/// [kg m²/s] The greatest angular momentum, or what the body has without its wheels if that is
/// more: the two may cancel.
double angularMomentumScale(const Body& body, std::size_t index, const std::vector<State>& truth) {
  const double moment = body.inv_I.cwiseInverse().maxCoeff();
  double scale = 0;
  for (const State& state : truth) {
    const BodyState& at = state.bodies[index];
    scale = std::max({scale, at.L_W.norm(), moment * angularVelocity(body.inv_I, at.L_P).norm()});
  }
  return scale;
}

/// rounding [m]: of the body's place; g [m/s²].
void addErrorsOfBody(const Body& of, std::size_t body, double rounding, double g,
                     const std::vector<State>& track, const std::vector<State>& truth,
                     Errors& worst) {
  const double L_scale = angularMomentumScale(of, body, truth);
  constexpr double kRounding = 1e-15;  // some units in the last place
  const double size = radiusOfGyration(of);
  double path = 0;
  for (std::size_t k = 1; k < truth.size(); ++k) {
    const BodyState& a = track[k].bodies[body];
    const BodyState& b = truth[k].bodies[body];
    path += distanceBetween(b, truth[k - 1].bodies[body]);
    raise(worst.attitude, angleBetween(a.q_WP, b.q_WP));
    // forces that cancel, as of one that hovers, leave an acceleration of their rounding
    const double t = truth[k].t - truth.front().t;
    const double noise = kRounding * (size + 0.5 * g * t * t);
    const double gap = std::max(0.0, distanceBetween(a, b) - rounding - noise);
    raise(worst.position, relative(gap, path));
    raise(worst.angular_momentum, relative((a.L_W - b.L_W).norm(), L_scale));
  }
}

double kineticEnergyOfAll(const World& world, const State& state) {
  double sum = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
    if (moves(world.bodies[i])) sum += kineticEnergy(world.bodies[i], state.bodies[i]);
  return sum;
}

/// [J] What the bodies gain who fall by their radius of gyration.
double fallEnergy(const World& world) {
  double sum = 0;
  for (const Body& body : world.bodies)
    if (moves(body)) sum += body.mass * world.g_W.norm() * radiusOfGyration(body);
  return sum;
}

}  // namespace

Errors errorsOf(const World& world, const std::vector<State>& track,
                const std::vector<State>& truth) {
  Errors worst;
  const std::vector<double> rounding = positionRounding(world, truth.front().bodies, {});
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
    if (moves(world.bodies[i]))
      addErrorsOfBody(world.bodies[i], i, rounding[i], world.g_W.norm(), track, truth, worst);
  double scale = fallEnergy(world);
  for (const State& state : truth) scale = std::max(scale, kineticEnergyOfAll(world, state));
  for (std::size_t k = 1; k < truth.size(); ++k)
    raise(worst.energy,
          relative(std::abs(mechanicalEnergy(world, track[k]) - mechanicalEnergy(world, truth[k])),
                   scale));
  return worst;
}

}  // namespace rigid_body_sim
