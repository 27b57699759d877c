#pragma once

#include <Eigen/Dense>

#include "dynamics/methods/system.hpp"

namespace rigid_body_sim {

/// Bodies near an equilibrium, as long as no law switches its mode: six coordinates a body, place
/// [m] and turn [rad] about the axes of the world. Their modes of vibration φ and the squares of
/// their frequencies λ:  K φ = λ M φ,  φᵀ M φ = 1,  K = −∂F/∂u.
class Equilibrium {
 public:
  /// longest: [m] over which K is differenced; small beside what the laws' forces change over.
  Equilibrium(const System& system, const SystemState& states, double longest);

  /// Whether K is symmetric, up to what differences leave: forces follow from a potential, and no
  /// motion can draw energy from them; and none of them drives bodies away.
  bool isStable() const { return stable_; }

  /// The states with all bodies at rest where no force is left, but for what pushes along neutral
  /// modes. False where that is not found. The states of laws follow the motion there.
  bool find();
  const SystemState& states() const { return states_; }

  /// [J] of the motion that begins with the velocities of `states`: ½ Vᵀ M V + ½ uᵀ K u, u from
  /// the equilibrium to where they are; without the part along neutral modes.
  double energy() const { return energy_; }

  /// Bounds on how far body k strays at that energy, and drifts along neutral modes within a time
  /// [s].
  double placeBound(std::size_t k, double duration) const { return bound(6 * k, duration); }
  double turnBound(std::size_t k, double duration) const { return bound(6 * k + 3, duration); }

 private:
  using Vector = Eigen::VectorXd;
  Vector forcesAt(const SystemState& states);
  SystemState movedBy(const Vector& u) const;
  void findStiffness(double longest);
  void findModes();
  double bound(std::size_t first, double duration) const;
  std::ptrdiff_t size() const { return 6 * static_cast<std::ptrdiff_t>(system_.bodies.size()); }

  const System& system_;
  SystemState states_;
  Workspace workspace_;
  Vector velocity_;
  Eigen::MatrixXd mass_, stiffness_, modes_;  // modes: columns
  Vector squares_;                            // [1/s²]; 0 of neutral modes
  Vector speeds_, pushes_;                    // along the modes
  double noise_ = 0;                          // [m/s²] of the pushes
  bool stable_ = false;
  double energy_ = 0;
};

}  // namespace rigid_body_sim
