#pragma once

#include <functional>

#include "tools/trade/trade_setting.hpp"

namespace rigid_body_sim {

/// The motion of a world with contact over a duration [s], by auto at the tightest tolerance, and
/// how far auto at ten times that tolerance and half the step comes from it. Both are runs of the
/// same integrator: their difference shows what tolerance, step and rounding leave, magnified from
/// impact to impact. known_until: while the difference is within error_budget. Throws
/// SimulationDiverged.
Reference contactReference(const World& world, const State& initial, double duration,
                           double error_budget);

/// In place of climbLadder for a world with contact, where tolerances decide about the error:
/// measures an integrator that follows them, auto, at the scene's step over a ladder of tolerances,
/// the scene's own among them. measured is called with each setting as soon as it is known.
void climbTolerances(const World& world, const Reference& reference, const std::string& integrator,
                     const std::function<void(const Setting&)>& measured,
                     const Patience& patience = {});

}  // namespace rigid_body_sim
