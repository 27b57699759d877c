#pragma once

#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/simulation.hpp>

namespace rigid_body_sim {

/// What is modelled of each body and how it is solved, a line a body:
///   wing_nut: free, asymmetric, exact
///   crate: gravity, wrenches, Taylor
///   upper: spring, drag, dop853 in substeps of 0.5 ms (2 per step)
///   table: fixed
/// Of more than 40 bodies, neighbours with the same line share it:
///   b0 to b99 (100 bodies): gravity, spherical, exact
/// Of the wrenches, those that the world schedules. Further lines say where auto found no
/// integrator to hold the tolerance, and what a trial of contact has found.
std::vector<std::string> describeSolution(const Simulation& simulation);

/// Says that steps were divided into more substeps than planned, and into how many, and of a named
/// integrator that its error is not known; empty if none was.
std::string describeSubsteps(const Simulation& simulation);

/// Says that rounding has been magnified by more than half of the digits of a number; empty if it
/// has not: by an integrator, what a thin body turns about its long axis, and what to do
/// (Simulation::magnification); by the motion itself, the start of a free rotation that is solved,
/// near the unstable axis, in a world of at most 100 bodies.
std::string describeMagnification(const Simulation& simulation);

/// The same of every motion that is solved, in a run from a start without inputs: a second run
/// shows it that starts 1e-10 beside it. Empty, too, where something is integrated, in a world with
/// laws, and where that run would take more than a tenth of a second.
std::string describeInstability(const Simulation& simulation, const State& start);

/// Says from when on the tolerance is not certain to be held, where errors are tracked
/// (Simulation::trackError); empty while it is.
std::string describePromise(const Simulation& simulation);

}  // namespace rigid_body_sim
