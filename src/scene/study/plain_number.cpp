#include "scene/study/plain_number.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace rigid_body_sim {

const std::vector<PlainNumber::Kind>& PlainNumber::kinds() {
  using Item = Eigen::Index;
  static const std::vector<Kind> kinds = {
      {"bodies", "mass",
       [](Scene& s, std::size_t n, Item) -> double& {
         return std::get<SolidDef>(s.bodies[n].composition).mass;
       },
       Rule::kPositive},
      {"bodies", "position[]",
       [](Scene& s, std::size_t n, Item i) -> double& { return s.bodies[n].position[i]; },
       Rule::kAny},
      {"bodies", "twist.linear[]",
       [](Scene& s, std::size_t n, Item i) -> double& { return s.bodies[n].twist.linear[i]; },
       Rule::kAny},
      {"bodies", "twist.angular[]",
       [](Scene& s, std::size_t n, Item i) -> double& { return s.bodies[n].twist.angular[i]; },
       Rule::kAny},
      {"wrenches", "force[]",
       [](Scene& s, std::size_t n, Item i) -> double& { return s.wrenches[n].force[i]; },
       Rule::kAny},
      {"wrenches", "torque[]",
       [](Scene& s, std::size_t n, Item i) -> double& { return s.wrenches[n].torque[i]; },
       Rule::kAny},
      {"wrenches", "point[]",
       [](Scene& s, std::size_t n, Item i) -> double& { return s.wrenches[n].point[i]; },
       Rule::kAny},
      {"wrenches", "start",
       [](Scene& s, std::size_t n, Item) -> double& { return s.wrenches[n].start; },
       Rule::kNotNegative},
      {"wrenches", "duration",
       [](Scene& s, std::size_t n, Item) -> double& { return s.wrenches[n].duration; },
       Rule::kPositive},
  };
  return kinds;
}

std::optional<PlainNumber> PlainNumber::at(const Scene& scene, const std::vector<PathStep>& steps,
                                           std::size_t entry) {
  if (steps.size() < 3) return std::nullopt;
  const std::string& list = steps[0].name;
  std::string path;
  for (std::size_t i = 2; i < steps.size(); ++i)
    path += steps[i].item ? "[]" : (i > 2 ? "." : "") + steps[i].name;
  // of any other the mass is part of, or follows from, more than one value
  if (path == "mass" && list == "bodies" &&
      !std::holds_alternative<SolidDef>(scene.bodies[entry].composition))
    return std::nullopt;
  const auto kind = std::find_if(kinds().begin(), kinds().end(),
                                 [&](const Kind& k) { return list == k.list && path == k.path; });
  if (kind == kinds().end()) return std::nullopt;
  return PlainNumber(*kind, entry, steps.back().item.value_or(0));
}

bool PlainNumber::set(double x, Scene& scene) const {
  const Rule rule = kind_->rule;
  const bool holds = rule == Rule::kPositive ? x > 0 : rule == Rule::kNotNegative ? x >= 0 : true;
  if (!holds || !std::isfinite(x)) return false;
  kind_->place(scene, entry_, item_) = x;
  return true;
}

}  // namespace rigid_body_sim
