#pragma once

#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "dynamics/run/law_watch.hpp"
#include "dynamics/run/pair_sweep.hpp"
#include "dynamics/run/run_state.hpp"

namespace rigid_body_sim {

/// All laws of a world that may begin to act, and when the first of them does.
class LawWatches {
 public:
  /// near: see near().
  LawWatches(const World& world, const LawTable& laws, std::set<std::size_t> near = {});

  /// [s] No law begins or ceases to act before; −∞ where that is not known.
  double quietUntil() const { return quiet_until_; }

  /// After any change from outside: of all bodies, or of these (ascending).
  void wakeUp();
  void wakeUp(const std::vector<std::size_t>& bodies);

  /// The same, of a run that goes on from a state in which those are near.
  void restart(std::set<std::size_t> near);

  /// Finds, where that is not known, which laws may act up to t_end that need bodies to be near
  /// each other. Returns whether they were looked for. looks_ahead: see PairSweep.
  bool findCandidates(const RunState& run, double t_end, bool looks_ahead);
  const PairSweep& pairs() const { return pairs_; }

  /// Finds quietUntil anew.
  void findQuiet(const RunState& run);

  /// A law that begins to act at time t [s], or bodies that are to be integrated together from
  /// then on, because they are near.
  struct Event {
    LawWatch* watch;
    double t;
    bool is_near = false;
  };

  /// The first up to t_end.
  std::optional<Event> firstEvent(const RunState& run, double t_end);

  /// Contacts that link bodies without acting, until the next step begins.
  const std::set<std::size_t>& near() const { return near_; }
  void setNear(const LawWatch& watch) { near_.insert(watch.law()); }

  /// At the start of a step, to t_end, forgets those that are near no more. Returns the bodies of
  /// those that do not act, to be parted.
  std::vector<std::size_t> forgetFar(const RunState& run, double t_end);

 private:
  bool isWatched(const LawWatch& watch, const RunState& run) const;
  std::optional<Event> eventOf(LawWatch& watch, const RunState& run, double t_end) const;
  bool isNear(const LawWatch& watch, const RunState& run, double t, double t_end) const;
  LawWatch* candidate(std::size_t law);
  template <class F>
  void forWatches(const F& f);

  std::vector<LawWatch> watches_;     // of laws whose bodies may be anywhere
  PairSweep pairs_;                   // the other laws
  std::vector<LawWatch> candidates_;  // those of them that may act now, by ascending laws
  std::set<std::size_t> near_;
  double quiet_until_;
};

}  // namespace rigid_body_sim
