#pragma once

#include <optional>
#include <vector>

#include <rigid_body_sim/scene/scene.hpp>

#include "scene/study/scene_path.hpp"

namespace rigid_body_sim {

/// Where a scene holds a number as its file says it: a sweep sets it there, without the reader of
/// the entry that holds it.
class PlainNumber {
 public:
  /// steps: of a path from the root of the file on; entry: index in its list. None where the value
  /// is anything else, or others follow from it.
  static std::optional<PlainNumber> at(const Scene& scene, const std::vector<PathStep>& steps,
                                       std::size_t entry);

  /// False, and nothing is set, for a number that breaks its rule: the reader says which.
  bool set(double x, Scene& scene) const;

 private:
  enum class Rule { kAny, kNotNegative, kPositive };
  struct Kind {
    const char* list;
    const char* path;  ///< in the entry; [] stands for an item
    double& (*place)(Scene& scene, std::size_t entry, Eigen::Index item);
    Rule rule;
  };
  static const std::vector<Kind>& kinds();

  PlainNumber(const Kind& kind, std::size_t entry, std::size_t item)
      : kind_(&kind), entry_(entry), item_(static_cast<Eigen::Index>(item)) {}

  const Kind* kind_;
  std::size_t entry_;
  Eigen::Index item_;
};

}  // namespace rigid_body_sim
