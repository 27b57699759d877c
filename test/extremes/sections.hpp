#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include "cell.hpp"

/// The sections of the map, one function each; integrators: of the catalogue, where the section
/// asks which.
namespace rigid_body_sim::extremes {

using Sizes = std::vector<double>;
const Sizes kSpins{0, 1e-300, 1e-154, 1e-100, 1e-10, 1, 1e3, 1e6, 1e20, 1e300};  // [rad/s]
const Sizes kTurns{1e-3, 1e-2, 0.1, 0.2, 0.4, 0.8, 1.6, 10, 100, 1e3, 1e6};      // [rad]
const Sizes kOffCentreForces{1e-300, 1e-100, 1, 1e3, 1e5, 1e20, 1e100, 1e300};   // [N]
const Sizes kStiffnesses{1e-300, 1, 1e6, 1e12, 1e18, 1e300};                     // [N/m]

// free bodies
Cells needles(const Names& integrators);
Cells plates(const Names& integrators);
Cells nearSpheres(const Names& integrators);
Cells nearlySymmetric(const Names& integrators);
Cells spins(const Names& integrators, const Sizes& sizes = kSpins);
Cells steps(const Names& integrators);
Cells turns(const Names& integrators, const Sizes& sizes = kTurns);
Cells separatrix(const Names& integrators);
Cells positions(const Names& integrators);

/// Errors at each power of ten of steps up to the given number.
Cells growth(const std::string& integrator, std::int64_t most_steps);

// bodies under wrenches and laws
Cells masses(const Names& integrators);
Cells centralForces(const Names& integrators);
Cells offCentreForces(const Names& integrators, const Sizes& sizes = kOffCentreForces);
Cells conflicts(const Names& integrators);
Cells arms(const Names& integrators);
Cells farPulls(const Names& integrators);
Cells throughZero(const Names& integrators);
Cells springs(const Names& integrators, const Sizes& sizes = kStiffnesses);
Cells tolerances();
Cells crowds(const Names& integrators, std::size_t bodies);
Cells schedules(const Names& integrators, int entries);

// bodies that touch the ground, by auto alone
Cells contactStiffnesses();
Cells contactMasses();
Cells contactSpeeds();
Cells contactDrops();
Cells contactFrictions();
Cells contactStarts(int steps = 100);
Cells contactCrowds(std::size_t bodies);

/// Those of one body without laws, in which an engine can take part like any integrator.
using NamedSection = std::pair<std::string, std::function<Cells(const Names&)>>;
std::vector<NamedSection> oneBodySections();

/// What the reader of scenes refuses, and how it says so.
Cells refusals();

}  // namespace rigid_body_sim::extremes
