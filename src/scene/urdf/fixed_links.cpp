#include "scene/urdf/fixed_links.hpp"

#include <algorithm>
#include <map>

namespace rigid_body_sim {

std::vector<PlacedLink> fixedLinks(const UrdfRobot& robot, const std::string& base) {
  const auto first = std::find_if(robot.links.begin(), robot.links.end(),
                                  [&](const UrdfLink& link) { return link.name == base; });
  if (first == robot.links.end()) return {};
  std::multimap<std::string, const UrdfLink*> fixed_to;
  for (const UrdfLink& link : robot.links)
    if (link.fixed) fixed_to.emplace(link.parent, &link);

  std::vector<PlacedLink> placed = {{&*first, Isometry3d::Identity()}};
  for (std::size_t i = 0; i < placed.size(); ++i) {
    const PlacedLink parent = placed[i];
    const auto [begin, end] = fixed_to.equal_range(parent.link->name);
    for (auto child = begin; child != end; ++child)
      placed.push_back({child->second, parent.X_BL * child->second->X_PL});
  }
  return placed;
}

}  // namespace rigid_body_sim
