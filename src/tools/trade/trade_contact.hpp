#pragma once

#include <functional>

#include "tools/trade/trade_setting.hpp"

namespace rigid_body_sim {

/// The motion of a world with contact over a duration [s], by auto at the tightest tolerance, and
/// how far two other runs come from it: at ten times that tolerance and half the step, and at a
/// third of the step. All are runs of the same integrator: their differences show what tolerance,
/// step and rounding leave, magnified from impact to impact. Where rounding decides, one difference
/// may be small by chance. known_until: while they are within error_budget. Throws
/// SimulationDiverged.
Reference contactReference(const World& world, const State& initial, double duration,
                           double error_budget);

/// In place of climbLadder for a world with contact, where tolerances decide about the error:
/// measures an integrator that follows them, auto, at the scene's step over a ladder of tolerances,
/// each as if the scene stated it, with the trial before the run that belongs to that. The scene's
/// own is among them, as it is written. measured is called with each setting as soon as it is
/// known.
void climbTolerances(const World& world, const Reference& reference, const std::string& integrator,
                     const std::function<void(const Setting&)>& measured,
                     const Patience& patience = {});

}  // namespace rigid_body_sim
