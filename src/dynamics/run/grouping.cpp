#include "dynamics/run/grouping.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "dynamics/run/check_input.hpp"

namespace rigid_body_sim {
namespace {

/// Throws std::invalid_argument unless each law that acts, and none that does not, belongs to a
/// group.
void requireLawsIn(const Groups& groups, const RunState& run) {
  std::vector<std::size_t> times(run.world->laws.size());
  for (const Group& group : groups.all())
    for (std::size_t law : group.bodies().laws) ++times[law];
  for (std::size_t law = 0; law < times.size(); ++law)
    if (times[law] != (run.acts(law) ? 1 : 0))
      throw std::invalid_argument("law " + std::to_string(law) + " (" +
                                  run.world->laws[law]->name() +
                                  "): one plan must have it, once, as long as it acts");
}

/// A body alone, whose motion was solved.
void anchorAsBefore(Group& group, const RunState& run, const State& start) {
  const std::size_t body = group.members().front();
  const MotionAnchor& anchor = start.anchors[body];
  if (!(anchor.horizon > anchor.t)) return;
  group.anchor(anchor);
  checkFollows(run.world->bodies[body], anchor, run.time, group.at(run.time, 0),
               start.bodies[body]);
}

}  // namespace

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

void Grouping::findCandidates(RunState& run, double t_end, bool looks_ahead) {
  if (watches_.findCandidates(run, t_end, looks_ahead))
    run.laws.setCandidates(*run.world, watches_.pairs().candidates());
}

void Grouping::form(RunState& run, const State& start, bool scheduled) {
  const World& world = *run.world;
  watches_.restart({start.near_laws.begin(), start.near_laws.end()});
  std::vector<std::size_t> candidates;
  for (std::size_t law : run.laws.ofPairs())
    if (run.acts(law) || watches_.near().count(law) > 0) candidates.push_back(law);
  run.laws.setCandidates(world, candidates);
  run.groups.clear(world.bodies.size());
  if (!start.anchors.empty() && planner_.fits(start.plans))
    restore(run, start);
  else
    formAnew(run, start, scheduled);
  findNextLink(run);
}

/// As the run had them that the state is from. Bodies without a plan are linked by what acts now.
void Grouping::restore(RunState& run, const State& start) {
  std::set<std::size_t> unplanned;
  for (std::size_t body : movingBodies(*run.world)) unplanned.insert(body);
  for (const MotionPlan& plan : start.plans) {
    const CoupledBodies bodies{plan.bodies, plan.laws, plan.waiting_laws};
    const MethodChoice choice = planner_.asPlanned(*run.world, bodies, run.schedules, plan);
    Group group = formedGroup(run, bodies, start, choice);
    if (choice.method && plan.at_rest) group.restAsBefore();
    if (!choice.method) anchorAsBefore(group, run, start);
    run.groups.add(std::move(group), run.schedules);
    for (std::size_t body : plan.bodies) unplanned.erase(body);
  }
  for (const CoupledBodies& bodies :
       coupledBodies(*run.world, run.laws, run.law_states, run.schedules,
                     {unplanned.begin(), unplanned.end()}))
    run.groups.add(
        formedGroup(run, bodies, start, planner_.later(*run.world, bodies, run.schedules)),
        run.schedules);
  requireLawsIn(run.groups, run);
}

void Grouping::formAnew(RunState& run, const State& start, bool scheduled) {
  const World& world = *run.world;
  const std::vector<CoupledBodies> all =
      coupledBodies(world, run.laws, run.law_states, run.schedules, movingBodies(world));
  const auto trials = std::count_if(all.begin(), all.end(), [&](const CoupledBodies& bodies) {
    return bodies.members.size() > 1 || needsOf(world, bodies, run.schedules) != 0;
  });
  const TrialStart trial_start{run.time, start.bodies, run.law_states, run.schedules};
  for (const CoupledBodies& bodies : all) {
    const MethodChoice choice = planner_.atStart(world, run.laws, bodies, trial_start, scheduled,
                                                 static_cast<std::size_t>(trials));
    Group group = formedGroup(run, bodies, start, choice);
    if (!choice.method && !run.laws.oneSided().empty()) group.anchorHere(run.schedules);
    run.groups.add(std::move(group), run.schedules);
  }
}

Group Grouping::formedGroup(const RunState& run, const CoupledBodies& bodies, const State& start,
                            const MethodChoice& choice) const {
  std::vector<BodyState> states;
  for (std::size_t body : bodies.members) states.push_back(start.bodies[body]);
  return Group(*run.world, run.laws, bodies, choice, run.time, std::move(states), run.law_states,
               run.schedules);
}

void Grouping::regroup(RunState& run, const std::vector<std::size_t>& bodies, double t, bool anew) {
  const World& world = *run.world;
  findCandidatesNow(run, static_cast<double>(run.steps + 1) * world.solver.time_step);
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
    formed.push_back(Group(world, run.laws, linked, choice, t, std::move(states), run.law_states,
                           run.schedules));
    // those who look for contacts and tethers ask for its motion at once
    if (solvable && !run.laws.oneSided().empty()) formed.back().anchorHere(run.schedules);
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

void Grouping::formBeside(RunState& run, const RunState& other, const Beside& beside) {
  planner_.change(beside);
  watches_ = LawWatches(*run.world, run.laws, watches_.near());
  run.groups.clear(run.world->bodies.size());
  for (const Group& group : other.groups.all()) {
    std::vector<BodyState> states;
    for (std::size_t body : group.members()) states.push_back(other.present(body));
    run.groups.add(Group(*run.world, run.laws, group.bodies(), changedBy(beside, group.choice()),
                         other.time, std::move(states), run.law_states, run.schedules),
                   run.schedules);
  }
}

}  // namespace rigid_body_sim
