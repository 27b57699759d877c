#pragma once

#include <string>
#include <vector>

#include "dynamics/run/grouping.hpp"
#include "dynamics/run/run_contacts.hpp"
#include "dynamics/run/step_record.hpp"

namespace rigid_body_sim {

/// A step within which bodies may be linked or part: by wrenches, and by laws that begin or cease
/// to act. Advances those bodies from one such instant to the next.
class LinkingStep {
 public:
  /// To t_end [s], the end of the step or an instant within it. The meter is null where nobody
  /// asks.
  LinkingStep(RunState& run, Grouping& grouping, RunContacts& contacts, StepRecord& record,
              double t_end, ExchangeMeter* meter);

  /// Advances the groups that form or part to the last instant at which they do, and puts bodies to
  /// rest that have come to it. Others stay where they are. Throws SimulationDiverged.
  void advance();

 private:
  void begin();
  [[noreturn]] void stopAt(const std::string& reason) const;
  bool advanceToNext();
  void advanceToEvent(const LawWatches::Event& event);
  bool advanceContact(double limit);
  bool advanceTo(double t, const std::vector<std::size_t>& bodies);
  double advanceGroup(std::size_t g, double t);
  void settle();

  RunState& run_;
  Grouping& grouping_;
  StepRecord& record_;
  std::vector<ContactEvent>& contact_events_;
  double t_end_;
  ExchangeMeter* meter_;
};

}  // namespace rigid_body_sim
