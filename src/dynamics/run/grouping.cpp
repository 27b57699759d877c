#include "dynamics/run/grouping.hpp"

#include <algorithm>
#include <utility>

namespace rigid_body_sim {

void Grouping::findNextLink(const RunState& run) {
  next_link_ = std::numeric_limits<double>::infinity();
  for (const WrenchSchedule& schedule : run.schedules)
    next_link_ = std::min(next_link_, schedule.nextCoupling());
}

/// A group in contact may have come to t already, and its schedules with it: what acts by then and
/// reaches out of a group links, too.
std::vector<std::size_t> Grouping::linkedBy(double t, const RunState& run) {
  const auto isApart = [&run](const PointWrench& wrench) {
    const std::size_t group = run.groups.indexOf(wrench.body);
    return (wrench.axes != kWorld && run.groups.indexOf(wrench.axes) != group) ||
           (wrench.point_frame != kWorld && run.groups.indexOf(wrench.point_frame) != group);
  };
  std::vector<std::size_t> bodies;
  for (const WrenchSchedule& schedule : run.schedules) {
    const std::vector<PointWrench>& active = schedule.active();
    if (schedule.nextCoupling() <= t || std::any_of(active.begin(), active.end(), isApart))
      schedule.addLinked(t, bodies);
  }
  return bodies;
}

void Grouping::findCandidates(RunState& run, double t_end) {
  if (watches_.findCandidates(run, t_end))
    run.laws.setCandidates(*run.world, watches_.pairs().candidates());
}

void Grouping::form(RunState& run, const State& start, bool scheduled) {
  const World& world = *run.world;
  watches_.restart();
  std::vector<std::size_t> acting;
  for (std::size_t law : run.laws.ofPairs())
    if (world.laws[law]->acts(run.law_states.data() + run.laws.firstState(law)))
      acting.push_back(law);
  run.laws.setCandidates(world, acting);
  run.groups.clear(world.bodies.size());
  const std::vector<CoupledBodies> all =
      coupledBodies(world, run.laws, run.law_states, run.schedules, movingBodies(world));
  const auto trials = std::count_if(all.begin(), all.end(), [&](const CoupledBodies& bodies) {
    return bodies.members.size() > 1 || needsOf(world, bodies, run.schedules) != 0;
  });
  const TrialStart trial_start{run.time, start.bodies, run.law_states, run.schedules};
  for (const CoupledBodies& bodies : all) {
    const MethodChoice choice = planner_.atStart(world, run.laws, bodies, trial_start, scheduled,
                                                 static_cast<std::size_t>(trials));
    run.groups.add(formedGroup(run, bodies, start, choice), run.schedules);
  }
  findNextLink(run);
}

Group Grouping::formedGroup(const RunState& run, const CoupledBodies& bodies, const State& start,
                            const MethodChoice& choice) const {
  std::vector<BodyState> states;
  for (std::size_t body : bodies.members) states.push_back(start.bodies[body]);
  Group group(*run.world, run.laws, bodies, choice, run.time, std::move(states), run.law_states,
              run.schedules);
  if (!choice.method && !start.anchors.empty())
    group.anchor(start.anchors[bodies.members[0]], run.schedules);
  else if (!choice.method && !run.laws.contacts().empty())
    group.anchor({run.time, start.bodies[bodies.members[0]]}, run.schedules);
  const auto isOfGroup = [&bodies](const MotionPlan& plan) {
    return plan.at_rest && plan.bodies == bodies.members;
  };
  if (choice.method && std::any_of(start.plans.begin(), start.plans.end(), isOfGroup))
    group.restAsBefore();
  return group;
}

void Grouping::regroup(RunState& run, const std::vector<std::size_t>& bodies, double t, bool anew) {
  const World& world = *run.world;
  std::vector<std::size_t> all;
  for (std::size_t g : run.groups.indicesOf(world, bodies)) {
    const std::vector<std::size_t>& members = run.groups[g].members();
    all.insert(all.end(), members.begin(), members.end());
    if (!anew) run.groups[g].putLawStates(run.laws, run.law_states);
  }
  std::sort(all.begin(), all.end());
  std::vector<Group> formed;
  for (const CoupledBodies& linked :
       coupledBodies(world, run.laws, run.law_states, run.schedules, all, watches_.near())) {
    const MethodChoice choice = planner_.later(world, linked, run.schedules);
    const Group& present = run.groups.of(linked.members[0]);
    const bool same = present.bodies() == linked;
    const bool solvable = !choice.method;
    if (!anew && same && solvable == !present.choice().method) continue;
    std::vector<BodyState> states;
    for (std::size_t body : linked.members) states.push_back(run.groups.at(body, t));
    const BodyState first = states.front();
    formed.push_back(Group(world, run.laws, linked, choice, t, std::move(states), run.law_states,
                           run.schedules));
    // those who look for contacts ask for its motion at once
    if (solvable && !run.laws.contacts().empty()) formed.back().anchor({t, first}, run.schedules);
  }
  std::vector<std::size_t> changed;
  for (const Group& group : formed)
    changed.insert(changed.end(), group.members().begin(), group.members().end());
  run.groups.remove(run.groups.indicesOf(world, changed));
  for (Group& group : formed) run.groups.add(std::move(group), run.schedules);
  watches_.wakeUp(all);
}

void Grouping::disturb(RunState& run, std::size_t body) {
  run.groups.of(body).fallBackToErrorControl();
  watches_.wakeUp(run.groups.of(body).members());
}

void Grouping::formAtTwiceTheStep(RunState& coarse, const RunState& fine) {
  planner_.doubleTurns();
  watches_ = LawWatches(*coarse.world, coarse.laws, watches_.near());
  coarse.groups.clear(coarse.world->bodies.size());
  for (const Group& group : fine.groups.all()) {
    MethodChoice choice = group.choice();
    choice.max_turn_share *= 2;
    std::vector<BodyState> states;
    for (std::size_t k = 0; k < group.members().size(); ++k)
      states.push_back(group.at(fine.time, k));
    coarse.groups.add(Group(*coarse.world, coarse.laws, group.bodies(), choice, fine.time,
                            std::move(states), coarse.law_states, coarse.schedules),
                      coarse.schedules);
  }
}

}  // namespace rigid_body_sim
