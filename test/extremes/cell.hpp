#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "support/reference_bench.hpp"

namespace rigid_body_sim::extremes {

/// One cell of the map of the extremes: what an integrator of the catalogue makes of a setting.
/// Errors are those of the worst body at the end of the run.
struct Cell {
  std::string section;          ///< such as "spin"
  std::string setting;          ///< what is extreme about it; a number where it is one
  std::string integrator;       ///< of the catalogue, or auto
  double attitude = 0;          ///< [rad]
  double position = 0;          ///< relative to the way from start to end; [m] where there is none
  double energy = 0;            ///< kinetic, relative to the reference's
  double angular_momentum = 0;  ///< in world axes, relative to the reference's
  std::string said{};           ///< what stopped the run; empty where it came to its end
  std::string warned{};         ///< what the solver says of itself before the run

  bool finite() const;
};
using Cells = std::vector<Cell>;
using Names = std::vector<std::string>;

/// How a setting is run.
struct Run {
  double time_step;  ///< [s]
  int steps;
  double duration() const { return time_step * steps; }
};

/// The truth at an end holds positions from those at the start on: far out, no scalar holds both.
struct Ends {
  reference::Motions motions;
};

/// Runs a bench by one integrator and compares its end with the truth; by what stands among the
/// others under that name, if any.
Cell measure(Cell cell, const test::Bench& bench, const Run& run, const Ends& truth);

/// Those that take the place of an integrator without being of the catalogue, by name.
using Measure = std::function<Cell(const Cell&, const test::Bench&, const Run&, const Ends&)>;
std::map<std::string, Measure>& others();

/// The same by each integrator.
void measureAll(const Cell& cell, const Names& integrators, const test::Bench& bench,
                const Run& run, const Ends& truth, Cells& cells);

/// The errors of a state of a bench against the truth, in long double: energies of motions whose
/// squares no double holds, too.
void compare(const test::Bench& bench, const State& state, const Ends& truth, Cell& cell);

/// Who says where bodies without torque are.
enum class Truth {
  series,       ///< Taylor series of Euler's equations in long double: nothing of the closed form
  quad_series,  ///< the same in 113 bits
  closed_form   ///< the free top in long double, which a million turns cost no digits
};

/// The motion of bodies on which nothing but gravity acts, after a duration [s].
Ends freeEnds(const test::Bench& bench, double duration, Truth truth);

/// The motion under all that the bench names, from the independent reference.
Ends referenceEnds(const test::Bench& bench, double duration);

}  // namespace rigid_body_sim::extremes
