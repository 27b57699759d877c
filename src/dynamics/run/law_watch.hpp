#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <rigid_body_sim/dynamics/world.hpp>

#include "dynamics/run/roam.hpp"

namespace rigid_body_sim {

/// Watches a law that does not act, on bodies whose motion it does not disturb meanwhile, for the
/// instant at which one of its guards falls below zero.
class LawWatch {
 public:
  LawWatch(const World& world, std::size_t law, std::size_t first_state);

  std::size_t law() const { return law_; }
  std::size_t firstState() const { return first_state_; }
  const std::vector<std::size_t>& members() const { return members_; }

  /// The law is not asked before this time [s]; 0 after any change from outside.
  double quietUntil() const { return quiet_until_; }
  void wakeUp() { quiet_until_ = 0; }

  /// State of a body at a time [s].
  using Motion = std::function<BodyState(std::size_t body, double t)>;

  /// What bounds the motion of a body from now on; nothing where that is not known.
  using Bound = std::function<std::optional<MotionBound>(std::size_t body)>;

  /// The first instant in (t, t_end] at which a guard has just fallen below zero, located to
  /// rounding; nothing where none does. Where the motion is bounded (ForceLaw::quietInFlight), none
  /// is missed, and it may be t itself. Else what falls below zero and rises again within a quarter
  /// of that time may be missed, unless the law's quietUntil excludes it.
  std::optional<double> firstEvent(double t, double t_end, const double* own, const Motion& motion,
                                   const Bound& bound);

  /// The same as ForceLaw::quietInFlight, the law and the bounds by the members.
  double quietInFlight(double t, const double* own, const Motion& motion, const Bound& bound) const;

  /// How far a body goes.
  using RoamOf = std::function<const Roam&(std::size_t body)>;

  /// Whether a guard may fall below zero while its bodies go no further.
  bool mayAct(const double* own, const RoamOf& roam) const;

  /// Switches the modes at an event, and adds touches and releases of contacts to `events`.
  void switchModes(double t, double* own, const Motion& motion,
                   std::vector<ContactEvent>& events) const;

 private:
  bool gatherBounds(const Bound& bound);
  double boundedUntil() const;
  std::optional<double> sampledEvent(double t, double t_end, const double* own,
                                     const Motion& motion);
  std::optional<double> certifiedEvent(double t, double t_end, const double* own,
                                       const Motion& motion);
  double firstBelowAfter(double before, double after, const double* own,
                         const Motion& motion) const;
  std::vector<BodyState> statesAt(double t, const Motion& motion) const;
  bool isBelow(double t, const double* own, const Motion& motion) const;

  std::size_t law_;                              // index in the world
  std::size_t first_state_;                      // in State::laws
  std::vector<std::size_t> members_;             // indices in the world, in the law's order
  std::vector<const Body*> bodies_;              // index by index of members_
  std::shared_ptr<const ForceLaw> compact_law_;  // by these indices
  double quiet_until_ = 0;
  std::vector<MotionBound> bounds_;  // index by index of members_
};

}  // namespace rigid_body_sim
