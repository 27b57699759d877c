#pragma once

#include <functional>
#include <memory>
#include <vector>

#include <rigid_body_sim/dynamics/wrench.hpp>

namespace rigid_body_sim {

/// How fast laws make one body swing and slow down, whatever the state: sums over the laws on it.
struct Stiffness {
  double frequency_squared = 0;  ///< [1/s²] bound on that of its swings
  double decay = 0;              ///< [1/s] bound on the rate of its damping
};

/// A law of force between bodies, points and the world. It never changes and keeps no state: it
/// adds the wrenches that follow from where the bodies are and how they move.
///
/// Over every motion, with F the law's wrenches and V its potential energy,
///   Σ f · v + τ · ω = −dV/dt + externalPower.
class ForceLaw {
 public:
  /// The bodies of a world or of a part of it, and their states, index by index.
  struct Bodies {
    const std::vector<const Body*>& bodies;
    const std::vector<BodyState>& states;
  };

  virtual ~ForceLaw() = default;

  /// For messages, such as "spring".
  virtual const char* name() const = 0;

  /// Indices of the bodies it acts on: at least one, none of them fixed.
  virtual std::vector<std::size_t> members() const = 0;

  /// The same law where the body of index i has index renamed(i).
  virtual std::shared_ptr<const ForceLaw> renamed(
      const std::function<std::size_t(std::size_t)>& index) const = 0;

  /// Adds the wrench on each body.
  virtual void addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const = 0;

  /// [J]
  virtual double potentialEnergy(const Bodies& at) const = 0;

  /// [W] Power that does not come out of the potential: negative where the law dissipates.
  virtual double externalPower(const Bodies& at) const = 0;

  /// Whether the wrenches depend on velocities.
  virtual bool isDamped() const = 0;

  /// Adds what the law brings about at any state, body by body, so that steps can be kept short
  /// enough.
  virtual void addStiffness(const std::vector<const Body*>& /*bodies*/,
                            std::vector<Stiffness>& /*stiffness*/) const {}

  /// [1/s] How fast, beside that, what it brings about at a state changes.
  virtual double rate(const Bodies& /*at*/) const { return 0; }

 protected:
  ForceLaw() = default;
  ForceLaw(const ForceLaw&) = default;
  ForceLaw& operator=(const ForceLaw&) = default;
};

/// What a method must accept to advance bodies; needs add up by |.
enum Need : unsigned {
  kCoupling = 1,  ///< wrenches that depend on place and attitude of any of the bodies
  kDrag = 2,      ///< drag, which has a flow of its own (dragKick)
  kDamping = 4    ///< other wrenches that depend on velocities
};

using ForceLaws = std::vector<std::shared_ptr<const ForceLaw>>;

}  // namespace rigid_body_sim
