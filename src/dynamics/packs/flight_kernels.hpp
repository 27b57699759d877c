#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "dynamics/packs/state_columns.hpp"
#include "dynamics/rotation/free_flight.hpp"

namespace rigid_body_sim {

/// What a kernel reads of a free flight, and where it writes its state: numbers side by side.
struct FlightLane {
  double dt;               ///< [s] since its start
  double mass;             ///< [kg]
  const double* f_W;       ///< [N]
  const double* start;     ///< the state there, in the order of StateColumn
  const double* rotation;  ///< ThetaRotation::numbers
};

/// The states that a kernel writes: of eight bodies.
struct alignas(64) FlightBlock {
  static constexpr std::size_t kLanes = 8;
  double columns[kStateColumns][kLanes];
};

/// Evaluates so many flights, at most eight; there must be eight lanes.
using FlightStep = void (*)(const FlightLane* lanes, std::size_t count, FlightBlock& block);

/// The evaluations of one width, of flights that circle e₁ and e₃. All widths give the same bits.
struct FlightKernels {
  std::size_t lanes;         ///< bodies at once
  const char* instructions;  ///< such as "AVX2"; empty: those that every processor has
  FlightStep first, last;
  /// Writes the states of all lanes.
  void (*copy)(const FlightBlock& block, BodyState* const* states);
};

/// Those that this processor can run, the narrowest first; that is one body at a time.
const std::vector<FlightKernels>& flightKernels();

/// The narrowest that takes all of so few bodies at once, or else the widest.
const FlightKernels& flightKernelsFor(std::size_t bodies);

/// Evaluates free flights several at a time, with the bits of FreeFlight::at.
class FlightBatch {
 public:
  FlightBatch() = default;

  /// At one width, whatever the number of bodies.
  explicit FlightBatch(const FlightKernels& kernels) : only_(&kernels) {}

  /// Writes the state `dt` [s] after the start of a flight; some of them by finish() only.
  void read(const FreeFlight& flight, double dt, BodyState& state);
  void finish();

 private:
  struct Shelf {
    std::size_t size = 0;
    std::array<FlightLane, FlightBlock::kLanes> lanes;
    std::array<BodyState*, FlightBlock::kLanes> states;
  };
  void evaluate(Shelf& shelf, FlightStep FlightKernels::*step);

  const FlightKernels* only_ = nullptr;
  Shelf first_, last_;
};

}  // namespace rigid_body_sim
