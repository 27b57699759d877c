#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/run/grouping.hpp"

namespace rigid_body_sim {

/// The contacts of a run: their touches and releases, and how they start anew.
class RunContacts {
 public:
  /// Touches and releases of the step that ends at a count of steps, in order.
  const std::vector<ContactEvent>& eventsOf(std::int64_t steps) const;

  /// Where the events of a step that begins are to be added, which ends at this count of steps. If
  /// it is taken back, those of the step before are found again.
  std::vector<ContactEvent>& beginStep(std::int64_t steps);

  /// A run begins, at this count of steps: contacts touch or not as their own states say.
  void place(std::int64_t steps);

  /// Puts the own states of contacts to what they are where nothing has happened before; what
  /// touches then is an event of the step that is done.
  void start(RunState& run, const std::vector<std::size_t>& laws,
             const std::vector<BodyState>& bodies);

  /// The same for a body whose state was set from outside: its contacts start anew, those of others
  /// that it neither touched nor touches go on as they are.
  void restart(RunState& run, Grouping& grouping, std::size_t body);

  /// For a body that stays in place and moves differently from now on: its contacts keep their
  /// states, and switch to the modes that go with the motion.
  void follow(RunState& run, Grouping& grouping, std::size_t body);

 private:
  void switchModes(RunState& run, const std::vector<std::size_t>& laws,
                   const std::vector<BodyState>& bodies);
  void regroup(RunState& run, Grouping& grouping, std::size_t body,
               const std::vector<std::size_t>& laws, bool anew);

  struct StepEvents {
    std::vector<ContactEvent> events;
    std::int64_t steps = 0;
  };
  StepEvents last_, previous_;
};

}  // namespace rigid_body_sim
