#pragma once

#include <cstdint>

#include "scene/study/study.hpp"

namespace rigid_body_sim {

/// The values of a study, run by run: each depends on the seed, the number of the run and the path
/// alone. Of a grid it is the run's number that decides, of a Latin hypercube the number of runs,
/// too.
class Draws {
 public:
  explicit Draws(const Study& study);

  /// All runs, the grids counted in.
  std::int64_t runs() const { return runs_; }

  /// What the path number `index` of the study has in a run; own: the scene's own value.
  SceneValue value(std::size_t index, std::int64_t run, const SceneValue& own) const;

  /// The same by the kind of its distribution, one of which it is: a number; one of the values that
  /// the study names, else null; a rotation.
  std::optional<double> number(std::size_t index, std::int64_t run) const;
  const SceneValue* named(std::size_t index, std::int64_t run) const;
  SceneValue rotated(std::size_t index, std::int64_t run, const SceneValue& own) const;

  /// A draw uniform over (0, 1); component: of those that a value takes.
  double uniform(std::size_t index, std::int64_t run, std::uint32_t component) const;

  /// A draw of mean 0 and variance 1.
  double normal(std::size_t index, std::int64_t run, std::uint32_t component) const;

 private:
  struct Path {
    std::uint64_t key = 0;
    std::int64_t stride = 1;  ///< of a grid: how many runs have the same value before the next
  };

  const Study& study_;
  std::vector<Path> paths_;
  std::int64_t runs_ = 0;
};

/// A permutation of 0 … size − 1 that a key decides: where it puts `place`. Four rounds of a
/// Feistel network, walked until the result is below the size. Source: Black and Rogaway, "Ciphers
/// with arbitrary finite domains", CT-RSA 2002.
std::uint64_t permuted(std::uint64_t key, std::uint64_t place, std::uint64_t size);

}  // namespace rigid_body_sim
