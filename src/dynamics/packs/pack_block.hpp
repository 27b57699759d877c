#pragma once

#include <cstddef>
#include <vector>

#include "dynamics/packs/state_columns.hpp"

namespace rigid_body_sim {

/// What a block holds of each of its bodies: the state of free motion, and what stays the same from
/// step to step.
enum PackColumn : int {
  kMagnificationColumn = kStateColumns,  ///< Stepper::magnification
  kForceColumn = 20,                     ///< [N] that acts, three
  kMassColumn = 23,                      ///< [kg]
  kRotationColumn = 24,     ///< [1/(kg m²)] 1/I; of strang, k_a, k_b, 1/I_r of its split; three
  kDifferencesColumn = 27,  ///< [kg m²] of rk4: I₂ − I₃, I₃ − I₁, I₁ − I₂
  kTurnColumn = 30,         ///< times |L_P|: |ω| h is at most that share of what a step follows
  kGrowthColumn = 31,       ///< [kg m²/s] by which |L| may grow while steps are certain
  /// One more, which nobody uses: blocks of a power of two would lie so that processors take what
  /// is read of one for what has just been written to the one before.
  kPackColumns = 33
};

/// What torques, forces in body axes and drag are made of, of bodies on which such act; see
/// HeldWrench and Drag.
enum PushColumn : int {
  kWeightColumn = 0,      ///< [N] of gravity, three columns; kForceColumn is then without
  kBodyForceColumn = 3,   ///< [N] f_P, three
  kCoupleColumn = 6,      ///< [N m] tau_W, three
  kBodyCoupleColumn = 9,  ///< [N m] tau_P, three
  kArmColumn = 12,        ///< [m] arm_P of a force at a point of the body, three
  kArmForceColumn = 15,   ///< [N] that force, three
  kLinearDragColumn = 18,
  kQuadraticDragColumn = 19,
  kAngularDragColumn = 20,
  kSpinDecayColumn = 21,    ///< [1/s] angular drag over the moments, three
  kSlowingColumn = 24,      ///< drag at rest slows by that share of what a step follows
  kSlowingGainColumn = 25,  ///< [1/(N s)] times |p|: quadratic drag, beside it
  kImpulseColumn = 26,      ///< [N s] by which |p| may grow while steps are certain
  kPushColumns = 27
};

/// Sixteen bodies: two registers of AVX-512. A column is two lines of the processor's cache, so
/// that what an integrator does not use is not read.
struct alignas(64) PackBlock {
  static constexpr std::size_t kLanes = 16;
  double columns[kPackColumns][kLanes];

  double* column(int c) { return columns[c]; }
  const double* column(int c) const { return columns[c]; }
};

/// The same bodies.
struct alignas(64) PushBlock {
  double columns[kPushColumns][PackBlock::kLanes];
};

/// Steps of bodies by themselves, as the integrators of the same names take them. Of strang one
/// for each pair of axes a, b that a RotationSplit of ascending moments has.
enum class PackKind { kSemiImplicitEuler, kStrang02, kStrang20, kStrang12, kMagnus4, kRk4 };
constexpr std::size_t kPackKinds = 6;

/// What acts beside a force in world axes at the centre of mass.
enum class PackLoad {
  kNone,
  kPush,  ///< torques, forces in body axes and at a point of the body
  kDrag   ///< drag, and any of these
};
constexpr std::size_t kPackLoads = 3;

/// Takes `count` steps of the lengths h [s] with the first `bodies` bodies of some blocks. Those
/// that share a pack with the last may be stepped, too. pushes: block by block; null without load.
using PackStep = void (*)(const double* h, int count, PackBlock* blocks, const PushBlock* pushes,
                          std::size_t bodies);

/// The steps of one width. All widths give the same bits.
struct PackKernels {
  std::size_t lanes;         ///< bodies at once
  const char* instructions;  ///< such as "AVX2"; empty: those that every processor has
  PackStep steps[kPackLoads][kPackKinds];

  PackStep step(PackKind kind, PackLoad load) const {
    return steps[static_cast<std::size_t>(load)][static_cast<std::size_t>(kind)];
  }
};

/// Those that this processor can run, the narrowest first; that is one body at a time.
const std::vector<PackKernels>& packKernels();

/// The narrowest that takes all of so few bodies at once, or else the widest.
const PackKernels& packKernelsFor(std::size_t bodies);

}  // namespace rigid_body_sim
