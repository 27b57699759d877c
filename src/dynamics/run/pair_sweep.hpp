#pragma once

#include <memory>
#include <vector>

#include "dynamics/run/groups.hpp"
#include "dynamics/run/roam.hpp"

namespace rigid_body_sim {

/// Finds which of the laws that need two bodies to be near each other may act within a time: those
/// of which the spheres overlap that hold the bodies meanwhile. No pair of bodies that are far
/// apart is looked at.
class PairSweep {
 public:
  PairSweep(const World& world, const LawTable& laws);

  bool hasLaws() const { return !table_->laws.empty(); }

  /// [s] Up to when the last sweep holds; −∞ after forget().
  double until() const { return until_; }
  void forget() { until_ = -std::numeric_limits<double>::infinity(); }

  /// Whether the last sweep may have gone beyond what was asked for. How far depends on earlier
  /// sweeps, so that what decides about the motion must not depend on its result.
  bool lookedAhead() const { return looked_ahead_; }

  /// From the present `time` [s] of the groups, or later ones of their own, to t_end; if
  /// looks_ahead, further where the motion of all bodies is known beforehand.
  void sweep(const World& world, const Groups& groups, const std::vector<WrenchSchedule>& schedules,
             double time, double t_end, bool looks_ahead);

  /// Of the last sweep: the laws that may act, ascending; and by body how far it goes.
  const std::vector<std::size_t>& candidates() const { return candidates_; }
  const Roam& roam(std::size_t body) const { return roams_[body]; }

 private:
  /// By the indices of a law's bodies, ascending, then by its own.
  struct PairLaw {
    std::size_t a, b, law;
  };
  struct Table {
    std::vector<PairLaw> laws;
    std::vector<double> radius;  // [m] by body; below zero: of no such law
  };
  void findCandidates();

  std::shared_ptr<const Table> table_;
  std::vector<Roam> roams_;
  std::vector<std::size_t> candidates_;
  double until_ = -std::numeric_limits<double>::infinity();
  bool looked_ahead_ = false;
  double window_ = 0;  // [s] how far it looks ahead
};

}  // namespace rigid_body_sim
