#include <algorithm>
#include <map>

#include "dynamics/run/run.hpp"

/// How single bodies move and accelerate between steps.
namespace rigid_body_sim {

std::vector<BodyMotion> Run::motions(const std::vector<std::size_t>& bodies, double t) const {
  if (t > time_ && linksUntil(t)) return goneOnTo(t).motions(bodies, t);
  std::map<std::size_t, std::vector<BodyMotion>> of_group;
  std::vector<WrenchSchedule> schedules;  // a copy, once a group has to be advanced
  std::vector<BodyMotion> motions;
  motions.reserve(bodies.size());
  for (const std::size_t body : bodies) {
    if (world_->bodies[body].fixed) {
      motions.push_back(motionOfFixed(body));
      continue;
    }
    const std::size_t g = groups_.indexOf(body);
    const auto [found, is_new] = of_group.try_emplace(g);
    if (is_new) found->second = motionsOfGroup(g, t, schedules);
    motions.push_back(found->second[groups_.memberOf(body)]);
  }
  return motions;
}

/// What holds after an event at that instant: a group stops there and takes over what begins.
std::vector<BodyMotion> Run::motionsOfGroup(std::size_t g, double t,
                                            std::vector<WrenchSchedule>& schedules) const {
  if (t < groups_.knownUntil(g) || t <= time_) return groups_[g].motions(std::max(t, time_));
  Group group = groups_[g];
  if (schedules.empty()) schedules = schedules_;
  advance(group, t, schedules);
  group.accept(t);
  return group.motions(t);
}

BodyMotion Run::motionOfFixed(std::size_t body) const {
  BodyMotion motion{start_->bodies[body], {}};
  motion.acceleration.felt_W = -world_->g_W;
  motion.acceleration.g_W = world_->g_W;
  motion.acceleration.centers = world_->gravity_centers;
  return motion;
}

}  // namespace rigid_body_sim
