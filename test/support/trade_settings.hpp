#pragma once

#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "dynamics/methods/catalogue.hpp"
#include "tools/trade/trade_ladder.hpp"

/// What the tests of trade measure with it.
namespace rigid_body_sim::test {

constexpr double kBriefly = 0.0005;  // [s] for timing a setting

/// Enough for runs of some ten thousand steps of the lecture's update.
inline Patience hasty(const World& world) {
  constexpr double kSteps = 2e4;
  return {kBriefly, kSteps * methodNamed("semi_implicit_euler").cost * movingBodyCount(world)};
}

/// Every integrator that supports the world, over its ladder; auto, which chooses one, left out.
inline std::vector<Setting> ladders(const World& world, const State& initial,
                                    const Reference& reference) {
  const Patience patience = hasty(world);
  std::vector<Setting> settings;
  for (const std::string& integrator : integratorsFor(world, initial))
    if (integrator != "auto")
      climbLadder(
          world, reference, integrator, [&](const Setting& s) { settings.push_back(s); }, patience);
  return settings;
}

/// In the unit of Method::cost.
inline double countedCost(const Method& method, std::int64_t evaluations) {
  return method.cost * static_cast<double>(evaluations) / method.evaluations;
}

/// The least counted cost of those in steps of at most time_step that stay within the tolerance.
inline double leastCost(const std::vector<Setting>& settings, double time_step, double tolerance) {
  double least = std::numeric_limits<double>::infinity();
  for (const Setting& s : settings)
    if (s.time_step <= time_step && s.errors.bounded() <= tolerance)
      least = std::min(least, countedCost(methodNamed(s.integrator), s.force_evaluations));
  return least;
}

}  // namespace rigid_body_sim::test
