#pragma once

#include <map>
#include <vector>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "dynamics/run/contact_bound.hpp"
#include "dynamics/run/group.hpp"
#include "dynamics/run/method_trial.hpp"

namespace rigid_body_sim {

/// Decides how each group is advanced: by the integrator that the scene names; with auto, solved
/// where that is possible, else by the cheapest integrator for the motion that the scene predicts,
/// or by one that its own error estimates control where something else happens.
class MethodPlanner {
  using Members = std::vector<std::size_t>;

 public:
  /// What trials have found for groups at the start of a run, by members: where no wrench and no
  /// command of the scene acts on the group or is to come, and where one does.
  struct Trials {
    struct Found {
      double start;  ///< [s] of the trial
      MethodChoice choice;
    };
    std::map<Members, Found> without, with;
  };

  /// Throws std::invalid_argument for an integrator that is unknown.
  explicit MethodPlanner(const World& world);

  /// For a run that is compared with another.
  void change(const Beside& beside);

  /// What the error estimate of a step in contact may reach.
  double contactBound() const { return bounds_.contact_bound; }
  /// Steps that are divided by error estimates out of contact are bounded in the same proportion.
  void setContactBound(double bound);

  /// What bodies that go by error estimates hold is what the trial of the whole run says.
  void setTrial(const ContactTrial& trial);

  /// See maxContactWork.
  double contactWork() const { return bounds_.contact_work; }
  void setContactWork(double work) { bounds_.contact_work = work; }

  /// Throws std::invalid_argument, naming the body, where the integrator does not support what the
  /// group needs.
  void requireSupport(unsigned needs, const std::string& body) const;

  /// The same for all that acts in the world, now or later.
  void requireSupport(const World& world) const;

  /// For a group that forms at the start of a run, or where it has been put back there, the same as
  /// then. scheduled: whether the scene's wrenches are to come, as at the start of time; trials:
  /// groups that share the time there is for trials.
  MethodChoice atStart(const World& world, const LawTable& laws, const CoupledBodies& group,
                       const TrialStart& start, bool scheduled, std::size_t trials);

  /// For a group that forms while the simulation runs, when there is no time for trials.
  MethodChoice later(const World& world, const CoupledBodies& group,
                     const std::vector<WrenchSchedule>& schedules) const;

  /// For another planner of the same world, of which the same start is asked.
  const Trials& trials() const { return trials_; }
  void setTrials(const Trials& trials) { trials_ = trials; }

  /// Whether these are plans of a run with this integrator.
  bool fits(const std::vector<MotionPlan>& plans) const;

  /// For a group as a plan has it. Throws std::invalid_argument, naming a body, where it cannot be
  /// advanced so.
  MethodChoice asPlanned(const World& world, const CoupledBodies& group,
                         const std::vector<WrenchSchedule>& schedules,
                         const MotionPlan& plan) const;

 private:
  bool isSolved(const World& world, const CoupledBodies& group, unsigned needs,
                const std::vector<WrenchSchedule>& schedules) const;
  MethodChoice bounded(MethodChoice choice) const;
  bool isWatched(const CoupledBodies& group) const;

  const Method* method_;       // null: auto
  std::vector<bool> watched_;  // body by body: its motion in a medium may not be solved
  double tolerance_;
  MethodChoice bounds_;           // for every choice
  int least_substeps_ = 1;        // of a step that is divided by error estimates
  bool regroups_ = false;         // see ContactTrial
  bool whole_run_tried_ = false;  // whether a trial of the whole run has shown what estimates hold
  Trials trials_;
};

MotionPlan toPlan(const Group& group);

}  // namespace rigid_body_sim
