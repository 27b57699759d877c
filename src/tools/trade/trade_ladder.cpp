#include "tools/trade/trade_ladder.hpp"

#include <optional>
#include <stdexcept>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "dynamics/methods/catalogue.hpp"
#include "tools/trade/cpu_time.hpp"

namespace rigid_body_sim {
namespace {

std::optional<Setting> tryMeasuring(const World& world, const Reference& reference,
                                    const std::string& integrator, double time_step,
                                    const Patience& patience) {
  try {
    return measureSetting(world, reference, integrator, time_step, patience);
  } catch (const SimulationDiverged&) {
    return std::nullopt;
  }
}

}  // namespace

std::vector<std::string> integratorsFor(const World& world, const State& initial) {
  std::vector<std::string> names;
  for (const Method& row : catalogue()) {
    World copy = world;
    copy.solver.integrator = row.name;
    try {
      Simulation(std::move(copy), initial);
      names.emplace_back(row.name);
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
  constexpr double kMaxSteps = 3e6;   // for a row that fails at every longer step
  constexpr double kLost = 1;         // [rad, relative] beyond it, the error says no more
  const double h = world.solver.time_step;
  std::optional<Setting> setting = tryMeasuring(world, reference, integrator, h, patience);
  if (setting) measured(*setting);
  const bool lost = !setting || setting->errors.bounded() > kLost || setting->parted;

  double step = h / 2;
  double last_error = setting ? setting->errors.bounded() : 1;
  for (int k = 0; k < kMaxHalvings; ++k, step /= 2) {
    if (setting && 2e-9 * setting->cpu_ns_per_sim_s * reference.duration > patience.longest_run)
      break;
    if (reference.duration / step > kMaxSteps) break;
    const double begin = cpuTime();
    setting = tryMeasuring(world, reference, integrator, step, patience);
    if (!setting && cpuTime() - begin > patience.longest_run) break;
    if (!setting) continue;
    measured(*setting);
    const double error = setting->errors.bounded();
    if (error < 1e-2 && error > last_error / 1.5) break;  // rounding has the better of the step
    last_error = error;
  }

  step = 2 * h;
  for (int k = 0; !lost && k < kMaxDoublings; ++k, step *= 2) {
    if (step > reference.duration / kFewestSteps) break;
    setting = tryMeasuring(world, reference, integrator, step, patience);
    if (!setting) break;
    measured(*setting);
    if (setting->errors.bounded() > kLost || setting->parted) break;
  }
}

}  // namespace rigid_body_sim
