#include "dynamics/rest/rest.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/rest/equilibrium.hpp"

namespace rigid_body_sim {
namespace {

constexpr std::size_t kMaxRestingBodies =
    24;  // of which modes of vibration are found in milliseconds

/// Whether it does no work on a body that comes back to where it was.
bool isConservative(const HeldWrench& held) {
  return held.is_zero || (held.tau_W.isZero(0) && held.f_P.isZero(0) && held.tau_P.isZero(0) &&
                          held.world_point_forces.empty());
}

/// [m/s²] By what the bodies are pressed together.
double pressing(const System& system) {
  double most = system.g_W.norm();
  for (std::size_t k = 0; k < system.bodies.size(); ++k)
    most = std::max(most, system.held[k].f_W.norm() / system.bodies[k]->mass);
  return most;
}

/// Whether all laws hold still while bodies stray so far from these states.
bool allHoldStill(const System& system, const SystemState& states,
                  const std::vector<Stray>& strays) {
  const ForceLaw::Bodies at{system.bodies, states.bodies};
  const auto holds = [&](const auto& law) { return law->holdsStill(at, strays); };
  bool all = std::all_of(system.laws.begin(), system.laws.end(), holds) &&
             std::all_of(system.flows.begin(), system.flows.end(), holds);
  forStatefulLaws(system, states, [&](const ForceLaw& law, const ForceLaw::Bodies& with_own) {
    all = all && law.holdsStill(with_own, strays);
  });
  return all;
}

/// Twice the bounds at the equilibrium. speeds: ½ m v² <= E.
std::vector<Stray> straysFrom(const System& system, const Equilibrium& equilibrium,
                              double horizon) {
  constexpr double kMargin = 2;
  std::vector<Stray> strays;
  for (std::size_t k = 0; k < system.bodies.size(); ++k) {
    const Body& body = *system.bodies[k];
    const double energy = 2 * equilibrium.energy();
    strays.push_back({kMargin * equilibrium.placeBound(k, horizon),
                      kMargin * equilibrium.turnBound(k, horizon),
                      kMargin * std::sqrt(energy / body.mass),
                      kMargin * std::sqrt(energy * body.inv_I.maxCoeff())});
  }
  return strays;
}

}  // namespace

/// What costs little to exclude most states.
bool RestSearch::mayRest(const System& system, const SystemState& states, double fastest) const {
  if (system.bodies.size() > kMaxRestingBodies || !system.coupled.empty()) return false;
  if (!system.pivots.empty()) return false;  // the equilibrium is that of bodies that may move
  if (!std::all_of(system.held.begin(), system.held.end(), isConservative)) return false;
  for (std::size_t k = 0; k < system.bodies.size(); ++k) {
    const Body& body = *system.bodies[k];
    const BodyState& s = states.bodies[k];
    const double swing = fastest * limit_;  // what a swing of that width moves and turns at
    if (!(s.p_W.norm() / body.mass <= swing * radiusOfGyration(body)) ||
        !(angularVelocity(body.inv_I, s.L_P).norm() <= swing))
      return false;
  }
  return allHoldStill(system, states, std::vector<Stray>(system.bodies.size()));
}

std::optional<SystemState> RestSearch::rest(const System& system, const SystemState& states,
                                            double fastest) const {
  const double pressed = pressing(system);
  if (!(pressed > 0) || !mayRest(system, states, fastest)) return std::nullopt;
  constexpr double kShare = 1e-3;  // of how deep a spring of that rate is pressed in
  Equilibrium equilibrium(system, states, kShare * pressed / (fastest * fastest));
  if (!equilibrium.isStable() || !equilibrium.find()) return std::nullopt;
  for (std::size_t k = 0; k < system.bodies.size(); ++k) {
    const double size = radiusOfGyration(*system.bodies[k]);
    if (!(equilibrium.turnBound(k, horizon_) <= limit_) ||
        !(equilibrium.placeBound(k, horizon_) <= limit_ * size))
      return std::nullopt;
  }
  if (!allHoldStill(system, equilibrium.states(), straysFrom(system, equilibrium, horizon_)))
    return std::nullopt;
  return equilibrium.states();
}

}  // namespace rigid_body_sim
