#pragma once

#include <limits>
#include <optional>
#include <set>
#include <vector>

#include "dynamics/run/groups.hpp"
#include "dynamics/run/law_watch.hpp"

namespace rigid_body_sim {

/// What laws that may begin to act are watched on: a run at the present.
struct WatchedRun {
  const World& world;
  const Groups& groups;
  const std::vector<WrenchSchedule>& schedules;
  const std::vector<double>& law_states;  ///< State::laws
  double time;                            ///< [s] start of the step
  LawWatch::Motion motion;                ///< within the step
};

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

  /// The same, and forgets which bodies are near.
  void restart();

  /// Finds quietUntil anew.
  void findQuiet(const WatchedRun& run);

  /// A law that begins to act at time t [s], or bodies that are to be integrated together from
  /// then on, because they are near.
  struct Event {
    LawWatch* watch;
    double t;
    bool is_near = false;
  };

  /// The first up to t_end.
  std::optional<Event> firstEvent(const WatchedRun& run, double t_end);

  /// Contacts that link bodies without acting, until the next step begins.
  const std::set<std::size_t>& near() const { return near_; }
  void setNear(const LawWatch& watch) { near_.insert(watch.law()); }

  /// At the start of a step, to t_end, forgets those that are near no more. Returns the bodies of
  /// those that do not act, to be parted.
  std::vector<std::size_t> forgetFar(const WatchedRun& run, double t_end);

 private:
  bool isWatched(const LawWatch& watch, const WatchedRun& run) const;
  std::optional<Event> eventOf(LawWatch& watch, const WatchedRun& run, double t_end) const;

  std::vector<LawWatch> watches_;
  std::set<std::size_t> near_;
  double quiet_until_;
};

}  // namespace rigid_body_sim
