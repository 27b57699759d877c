#include <algorithm>
#include <map>

#include "dynamics/run/run.hpp"

/// How single bodies move and accelerate between steps.
namespace rigid_body_sim {
namespace {

/// What holds after an event at that instant: a group stops there and takes over what begins.
/// schedules: a copy, once a group has to be advanced.
std::vector<BodyMotion> motionsOfGroup(const RunState& run, std::size_t g, double t,
                                       std::vector<WrenchSchedule>& schedules) {
  const bool is_packed = run.packs.holds(run.groups[g].members().front());
  if (!is_packed && (t < run.groups.knownUntil(g) || t <= run.time))
    return run.groups[g].motions(std::max(t, run.time));
  Group group = run.groupNow(g);
  if (t <= run.time) return group.motions(run.time);
  if (schedules.empty()) schedules = run.schedules;
  run.advance(group, t, schedules, nullptr);
  group.accept(t);
  return group.motions(t);
}

BodyMotion motionOfFixed(const RunState& run, std::size_t body) {
  BodyMotion motion{run.start->bodies[body], {}};
  motion.acceleration.felt_W = -run.world->g_W;
  motion.acceleration.g_W = run.world->g_W;
  motion.acceleration.centers = run.world->gravity_centers;
  return motion;
}

}  // namespace

std::vector<BodyMotion> Run::motions(const std::vector<std::size_t>& bodies, double t) const {
  if (t > now_.time && grouping_.mayChangeBy(t)) return goneOnTo(t).motions(bodies, t);
  std::map<std::size_t, std::vector<BodyMotion>> of_group;
  std::vector<WrenchSchedule> schedules;
  std::vector<BodyMotion> motions;
  motions.reserve(bodies.size());
  for (const std::size_t body : bodies) {
    if (!moves(now_.world->bodies[body])) {
      motions.push_back(motionOfFixed(now_, body));
      continue;
    }
    const std::size_t g = now_.groups.indexOf(body);
    const auto [found, is_new] = of_group.try_emplace(g);
    if (is_new) found->second = motionsOfGroup(now_, g, t, schedules);
    motions.push_back(found->second[now_.groups.memberOf(body)]);
  }
  return motions;
}

}  // namespace rigid_body_sim
