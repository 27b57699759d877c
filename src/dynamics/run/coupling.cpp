#include "dynamics/run/coupling.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "dynamics/actuators/actuator_law.hpp"
#include "dynamics/methods/catalogue.hpp"

namespace rigid_body_sim {
namespace {

/// Representative of a body in a forest of parents (union–find with path halving).
std::size_t root(std::vector<std::size_t>& parent, std::size_t body) {
  while (parent[body] != body) body = parent[body] = parent[parent[body]];
  return body;
}

/// The bodies that a wrench links: acted on, and turned with.
std::vector<std::size_t> bodiesOf(const PointWrench& wrench) {
  std::vector<std::size_t> bodies;
  for (std::size_t body : {wrench.body, wrench.axes, wrench.point_frame})
    if (body < kOwnBody) bodies.push_back(body);
  return bodies;
}

/// Links the bodies of a set; those that are fixed, or not among the given, are passed over.
class Linker {
 public:
  explicit Linker(const std::vector<std::size_t>& bodies)
      : bodies_(bodies), parent_(bodies.size()) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  void link(const std::vector<std::size_t>& bond) {
    std::size_t first = bodies_.size();
    for (std::size_t body : bond) {
      const auto it = std::lower_bound(bodies_.begin(), bodies_.end(), body);
      if (it == bodies_.end() || *it != body) continue;
      const auto k = static_cast<std::size_t>(it - bodies_.begin());
      if (first == bodies_.size()) first = k;
      parent_[root(parent_, k)] = root(parent_, first);
    }
  }

  /// Groups ascend by their first member.
  std::vector<std::vector<std::size_t>> groups() {
    std::vector<std::vector<std::size_t>> groups;
    std::vector<std::size_t> group_of(bodies_.size(), bodies_.size());
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      std::size_t& group = group_of[root(parent_, k)];
      if (group == bodies_.size()) {
        group = groups.size();
        groups.emplace_back();
      }
      groups[group].push_back(bodies_[k]);
    }
    return groups;
  }

 private:
  const std::vector<std::size_t>& bodies_;  // ascending
  std::vector<std::size_t> parent_;         // index by index
};

/// Those of the near laws of which a body has to be integrated: because it is acted on, or linked
/// with such a body by a wrench or by another near law.
template <class Acts>
std::vector<std::size_t> linkingNear(const World& world, const LawTable& laws,
                                     const std::vector<WrenchSchedule>& schedules,
                                     const std::vector<std::size_t>& bodies,
                                     const std::set<std::size_t>& near, const Acts& acts) {
  std::set<std::size_t> integrated;
  for (std::size_t body : bodies)
    for (const PointWrench& wrench : schedules[body].active()) {
      if (HeldWrench::holds(wrench)) continue;
      const std::vector<std::size_t> linked = bodiesOf(wrench);
      integrated.insert(linked.begin(), linked.end());
    }
  const auto isIntegrated = [&](std::size_t body) {
    const std::vector<std::size_t>& of_body = laws.of(body);
    return world.solver.integrator != "auto" || integrated.count(body) > 0 ||
           std::any_of(of_body.begin(), of_body.end(), acts);
  };
  std::vector<std::size_t> linking;
  std::set<std::size_t> rest = near;
  for (bool grows = true; grows;) {
    grows = false;
    for (auto law = rest.begin(); law != rest.end();) {
      const std::vector<std::size_t> members = world.laws[*law]->members();
      if (std::none_of(members.begin(), members.end(), isIntegrated)) {
        ++law;
        continue;
      }
      integrated.insert(members.begin(), members.end());
      linking.push_back(*law);
      law = rest.erase(law);
      grows = true;
    }
  }
  return linking;
}

/// Adds the contacts and tethers between the group's bodies that do not act.
void addWaiting(const World& world, const LawTable& laws, const std::vector<double>& law_states,
                CoupledBodies& group) {
  const auto isHere = [&group](std::size_t body) {
    return std::binary_search(group.members.begin(), group.members.end(), body);
  };
  for (std::size_t body : group.members) {
    for (std::size_t index : laws.of(body)) {
      const ForceLaw& law = *world.laws[index];
      if (!law.isOneSided() || law.acts(law_states.data() + laws.firstState(index))) continue;
      const std::vector<std::size_t> members = law.members();
      if (members.front() == body && std::all_of(members.begin(), members.end(), isHere))
        group.waiting.push_back(index);
    }
  }
  std::sort(group.waiting.begin(), group.waiting.end());
}

}  // namespace

std::vector<std::size_t> movingBodies(const World& world) {
  std::vector<std::size_t> moving;
  for (std::size_t body = 0; body < world.bodies.size(); ++body)
    if (moves(world.bodies[body])) moving.push_back(body);
  return moving;
}

LawTable::LawTable(const World& world)
    : constant_(std::make_shared<const Constant>(constantOf(world))) {
  if (!ofPairs().empty()) of_body_ = constant_->of_body;
}

LawTable::Constant LawTable::constantOf(const World& world) {
  Constant constant;
  constant.of_body.resize(world.bodies.size());
  for (std::size_t i = 0; i < world.laws.size(); ++i) {
    const ForceLaw& law = *world.laws[i];
    constant.first_state.push_back(constant.state_count);
    constant.state_count += law.stateCount();
    if (law.needs() & kContact) constant.contacts.push_back(i);
    if (law.isOneSided()) constant.one_sided.push_back(i);
    if (law.guardCount() > 0 && std::isfinite(law.touchRadius(0))) {
      constant.of_pairs.push_back(i);
      continue;
    }
    if (law.guardCount() > 0) constant.guarded.push_back(i);
    for (std::size_t body : law.members()) constant.of_body[body].push_back(i);
  }
  return constant;
}

void LawTable::setCandidates(const World& world, const std::vector<std::size_t>& laws) {
  if (laws == candidates_) return;
  const auto isOfPair = [this](std::size_t law) {
    return std::binary_search(ofPairs().begin(), ofPairs().end(), law);
  };
  const auto clear = [&](std::size_t body) {
    std::vector<std::size_t>& of = of_body_[body];
    of.erase(std::remove_if(of.begin(), of.end(), isOfPair), of.end());
  };
  for (std::size_t law : candidates_)
    for (std::size_t body : world.laws[law]->members()) clear(body);
  for (std::size_t law : laws)
    for (std::size_t body : world.laws[law]->members()) of_body_[body].push_back(law);
  candidates_ = laws;
}

std::vector<double> LawTable::start(const World& world) const {
  std::vector<double> states(stateCount());
  for (std::size_t i = 0; i < world.laws.size(); ++i)
    if (world.laws[i]->stateCount() > 0) world.laws[i]->setStart(states.data() + firstState(i));
  return states;
}

std::vector<CoupledBodies> coupledBodies(const World& world, const LawTable& laws,
                                         const std::vector<double>& law_states,
                                         const std::vector<WrenchSchedule>& schedules,
                                         const std::vector<std::size_t>& bodies,
                                         const std::set<std::size_t>& near) {
  const auto acts = [&](std::size_t law) {
    return world.laws[law]->acts(law_states.data() + laws.firstState(law));
  };
  Linker linker(bodies);
  std::vector<std::size_t> acting;
  for (std::size_t body : bodies) {
    for (std::size_t law : laws.of(body)) {
      const std::vector<std::size_t> members = world.laws[law]->members();
      const bool is_first = members.front() == body;
      if (!is_first || !acts(law)) continue;
      acting.push_back(law);
      linker.link(members);
    }
    for (const PointWrench& wrench : schedules[body].active()) linker.link(bodiesOf(wrench));
  }
  for (std::size_t law : linkingNear(world, laws, schedules, bodies, near, acts))
    linker.link(world.laws[law]->members());
  std::sort(acting.begin(), acting.end());
  acting.erase(std::unique(acting.begin(), acting.end()), acting.end());

  std::vector<CoupledBodies> groups;
  std::map<std::size_t, std::size_t> group_of;
  for (std::vector<std::size_t>& members : linker.groups()) {
    for (std::size_t body : members) group_of[body] = groups.size();
    groups.push_back({std::move(members), {}, {}});
  }
  for (std::size_t law : acting)
    groups[group_of[world.laws[law]->members().front()]].laws.push_back(law);
  if (!laws.oneSided().empty())
    for (CoupledBodies& group : groups) addWaiting(world, laws, law_states, group);
  return groups;
}

unsigned needsAhead(const World& world, const CoupledBodies& group,
                    const std::vector<WrenchSchedule>& schedules) {
  unsigned needs = 0;
  for (std::size_t law : group.waiting) needs |= world.laws[law]->needs();
  for (std::size_t body : group.members)
    if (const ActuatorSchedule* actuators = schedules[body].actuators())
      needs |= needsOf(actuators->table());
  return needs;
}

unsigned needsOf(const World& world, const CoupledBodies& group,
                 const std::vector<WrenchSchedule>& schedules) {
  unsigned needs = 0;
  for (std::size_t law : group.laws) needs |= world.laws[law]->needs();
  for (std::size_t body : group.members)
    if (!schedules[body].allHeld()) needs |= kCoupling;
  return needs == 0 ? needs : needs | needsAhead(world, group, schedules);
}

void requireSupport(const World& world) {
  std::vector<std::pair<unsigned, std::size_t>> needs;  // and whose
  for (const PointWrench& wrench : world.wrenches)
    if (!HeldWrench::holds(wrench)) needs.emplace_back(kCoupling, wrench.body);
  for (const auto& law : world.laws) needs.emplace_back(law->needs(), law->members().front());
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
    if (!world.bodies[i].actuators.empty())
      needs.emplace_back(needsOf(actuatorTable(world.bodies[i])), i);
  unsigned all = 0;
  for (const auto& [need, body] : needs) all |= need;
  const Method& method = methodNamed(world.solver.integrator);
  for (const auto& [need, body] : needs) requireSupport(method, need, world.bodies[body].name, all);
}

}  // namespace rigid_body_sim
