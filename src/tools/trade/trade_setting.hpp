#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/trade/trade_reference.hpp"

namespace rigid_body_sim {

/// An integrator and a step, with what they cost and what for.
struct Setting {
  std::string integrator;
  double time_step = 0;  ///< [s]
  Errors errors;
  double cpu_ns_per_sim_s = 0;         ///< [ns/s] processor time per simulated second
  std::int64_t force_evaluations = 0;  ///< over the whole run
  bool parted = false;                 ///< whether steps had to be taken in parts
};

/// How much processor time may be spent.
struct Patience {
  double timing = 0.04;       ///< [s] on timing a setting: a hundred runs of most
  double longest_run = 0.15;  ///< [s] on one run, with shorter steps than the scene's
};

/// Runs a scene with an integrator and a step over the duration of the reference, once for the
/// errors and several times for the processor time, from the same state. What is done before the
/// first step, as by auto, is not timed. Throws std::invalid_argument where the integrator refuses
/// the scene, and SimulationDiverged.
Setting measureSetting(const World& world, const Reference& reference,
                       const std::string& integrator, double time_step, const Patience& patience);

/// The greatest error that can be told apart from the reference's own.
double resolvedError(const Setting& setting, const Reference& reference);

/// The settings that none beats in both error and processor time, by ascending time. Errors that
/// the reference cannot tell apart are equal.
std::vector<Setting> paretoFront(std::vector<Setting> settings, const Reference& reference);

/// The cheapest whose error stays within the budget even if the reference's own comes on top; null
/// when none does.
const Setting* cheapestWithin(const std::vector<Setting>& settings, const Reference& reference,
                              double error_budget);

}  // namespace rigid_body_sim
