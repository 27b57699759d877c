#include "tools/trade/trade_ladder.hpp"

#include <optional>
#include <stdexcept>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "dynamics/methods/catalogue.hpp"

namespace rigid_body_sim {
std::vector<std::string> integratorsFor(const World& world, const State& initial) {
  std::vector<std::string> names;
  for (const Method& method : catalogue()) {
    World copy = world;
    copy.solver.integrator = method.name;
    try {
      const Simulation accepts(std::move(copy), initial);
      names.emplace_back(method.name);
    } catch (const std::invalid_argument&) {
      continue;  // it refuses the scene
    }
  }
  names.emplace_back("auto");
  return names;
}

void climbLadder(const World& world, const Reference& reference, const std::string& integrator,
                 const std::function<void(const Setting&)>& measured, const Patience& patience) {
  constexpr int kMaxHalvings = 24, kMaxDoublings = 10;
  constexpr double kFewestSteps = 8;  // that the duration is to be taken in
  constexpr double kLost = 1;         // [rad, relative] beyond it, the error says no more
  const double h = world.solver.time_step;
  const double least_cost = (integrator == "auto" ? 1 : methodNamed(integrator).cost);
  // of a run with the step, if none is divided
  const auto least_work = [&](double step) {
    return least_cost * movingBodyCount(world) * reference.duration / step;
  };
  std::optional<Setting> setting = tryMeasuring(world, reference, integrator, h, patience);
  if (setting) measured(*setting);
  const bool lost = !setting || setting->errors.bounded() > kLost || setting->has_substeps;

  double step = h / 2;
  double last_error = setting ? setting->errors.bounded() : 1;
  for (int k = 0; k < kMaxHalvings; ++k, step /= 2) {
    if (setting && std::max(2 * setting->work, least_work(step)) > patience.most_work) break;
    if (least_work(step) > 2 * patience.most_work) break;  // where every longer step has failed
    setting = tryMeasuring(world, reference, integrator, step, patience);
    if (!setting) continue;
    measured(*setting);
    const double error = setting->errors.bounded();
    if (error < 1e-2 && error >= last_error / 1.5) break;  // rounding dominates
    last_error = error;
  }

  step = 2 * h;
  for (int k = 0; !lost && k < kMaxDoublings; ++k, step *= 2) {
    if (step > reference.duration / kFewestSteps) break;
    setting = tryMeasuring(world, reference, integrator, step, patience);
    if (!setting) break;
    measured(*setting);
    if (setting->errors.bounded() > kLost || setting->has_substeps) break;
  }
}

}  // namespace rigid_body_sim
