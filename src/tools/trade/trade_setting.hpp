#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/trade/trade_reference.hpp"

namespace rigid_body_sim {

/// An integrator and a step, with what they cost and what for.
struct Setting {
  std::string integrator;
  double time_step = 0;  ///< [s]
  double tolerance = 0;  ///< [rad, relative] where it decides about the error, with contact; else 0
  Errors errors;
  double cpu_ns_per_sim_s = 0;         ///< [ns/s] processor time per simulated second
  std::int64_t force_evaluations = 0;  ///< over the whole run
  double work = 0;  ///< of the whole run, counted: in steps of strang with one body; 0: solved
  bool has_substeps = false;  ///< whether steps had to be divided
};

/// How much may be spent.
struct Patience {
  double timing = 0.04;    ///< [s] of processor time on timing a setting: a hundred runs of most
  double most_work = 5e5;  ///< of one run with shorter steps than the scene's: tenths of a second
};

/// Bodies that are not fixed.
double movingBodyCount(const World& world);

/// Runs a scene with an integrator and a step over the duration of the reference, once for the
/// errors and several times for the processor time, from the same state. What is done before the
/// first step, as by auto, is not timed. Throws std::invalid_argument where the integrator refuses
/// the scene, and SimulationDiverged.
Setting measureSetting(const World& world, const Reference& reference,
                       const std::string& integrator, double time_step, const Patience& patience);

/// The same; nothing where the motion diverges.
std::optional<Setting> tryMeasuring(const World& world, const Reference& reference,
                                    const std::string& integrator, double time_step,
                                    const Patience& patience);

/// The greatest error that can be told apart from the reference's own.
double resolvedError(const Setting& setting, const Reference& reference);

/// Whether a setting has a place on logarithmic axes of processor time and error.
bool canBeDrawn(const Setting& setting);

/// Why none of the settings can be drawn; empty where some can.
std::string pictureFault(const std::vector<Setting>& settings);

/// The settings that none beats in both error and processor time, by ascending time. Errors that
/// the reference cannot tell apart are equal.
std::vector<Setting> paretoFront(std::vector<Setting> settings, const Reference& reference);

/// The setting of the least work whose error stays within the budget even if the reference's own
/// comes on top; null when none does. Of those of equal work, one of the scene's integrator; of
/// those, the one with the scene's step, else with the shortest. Nothing here is timed: the same
/// scene gives the same setting every time.
const Setting* cheapestWithin(const std::vector<Setting>& settings, const Reference& reference,
                              double error_budget, const SolverOptions& scene);

}  // namespace rigid_body_sim
