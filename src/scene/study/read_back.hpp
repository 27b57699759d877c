#pragma once

#include <optional>
#include <string>
#include <vector>

#include <rigid_body_sim/dynamics/world.hpp>
#include <rigid_body_sim/scene/scene.hpp>

#include "scene/study/varied_scene.hpp"

namespace rigid_body_sim {

/// Reads the value at a path of a scene back from the world that was built from it.
class ReadBack {
 public:
  /// body: that the path names, as an index, or VariedScene::kNoBody.
  ReadBack(const std::string& path, std::size_t body);

  /// As many as a value of a scene may have, without memory of its own.
  using Numbers = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, 4, 1>;

  /// The numbers that the world and its initial state have at the path; none for one that they do
  /// not keep as it was given, such as the length of a part's side.
  std::optional<Numbers> numbers(const Scene& scene, const World& world,
                                 const State& initial) const;

 private:
  std::optional<Vector3d> vector(const Scene& scene, const World& world,
                                 const State& initial) const;
  std::optional<double> solverNumber(const World& world) const;
  std::optional<double> bodyNumber(const World& world) const;

  std::string whole_;  ///< the path without the last item's number, and without the body
  std::size_t body_;
  std::optional<Eigen::Index> item_;
  std::optional<std::size_t> wrench_;
};

/// What to write for a value that was set: none, it is as it was given, where the world has it, but
/// for rounding; what the world has where it differs by more.
std::optional<SceneValue> otherReadBack(const SceneValue& given,
                                        const std::optional<ReadBack::Numbers>& world);

}  // namespace rigid_body_sim
