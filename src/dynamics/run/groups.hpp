#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "dynamics/run/group.hpp"

namespace rigid_body_sim {

/// The groups of a run, and to which of them each body that moves belongs.
class Groups {
 public:
  /// [s] Of a group whose motion is not known beforehand.
  static constexpr double kNotKnown = -std::numeric_limits<double>::infinity();

  /// Forgets all groups, and what they counted. bodies: number of them in the world.
  void clear(std::size_t bodies);

  void add(Group group, const std::vector<WrenchSchedule>& schedules);

  /// Removes groups, by ascending indices; what they counted is kept.
  void remove(const std::vector<std::size_t>& indices);

  /// Of groups that are removed.
  struct Counts {
    int max_substeps = 1;
    double magnification = 0;
    std::int64_t evaluations = 0;
    double work = 0;  ///< the same, each as often as it is of a body
  };
  const Counts& counts() const { return removed_; }
  void setCounts(const Counts& counts) { removed_ = counts; }

  std::size_t size() const { return groups_.size(); }
  Group& operator[](std::size_t g) { return groups_[g]; }
  const Group& operator[](std::size_t g) const { return groups_[g]; }
  const std::vector<Group>& all() const { return groups_; }
  std::vector<Group>& all() { return groups_; }

  /// Of a body that moves: the index of its group, and its own among the members.
  std::size_t indexOf(std::size_t body) const { return group_of_[body]; }
  std::size_t memberOf(std::size_t body) const { return member_of_[body]; }
  /// Whether a body moves, and so has a group.
  bool has(std::size_t body) const { return member_of_[body] != kNone; }

  Group& of(std::size_t body) { return groups_[group_of_[body]]; }
  const Group& of(std::size_t body) const { return groups_[group_of_[body]]; }

  /// Indices of the groups of these bodies, ascending. Fixed bodies have none.
  std::vector<std::size_t> indicesOf(const World& world,
                                     const std::vector<std::size_t>& bodies) const;

  /// The state of a body at a time from the present of its group to Group::knownUntil.
  BodyState at(std::size_t body, double t) const {
    return groups_[group_of_[body]].at(t, member_of_[body]);
  }

  /// Whether the motion of all bodies is known beforehand.
  bool allSolvedAhead() const {
    return std::all_of(groups_.begin(), groups_.end(),
                       [](const Group& group) { return group.isSolvedAhead(); });
  }

  /// Group::knownUntil of group g; kNotKnown once it is forgotten.
  double knownUntil(std::size_t g) const { return known_until_[g]; }

  /// The first group from g on, up to `end`, that is not known beyond a time t [s]; else `end`.
  std::size_t firstNotKnownBeyond(double t, std::size_t g, std::size_t end) const {
    const double* known_until = known_until_.data();
    while (g < end && t < known_until[g]) ++g;
    return g;
  }

  void forgetKnown(std::size_t g) { known_until_[g] = kNotKnown; }

  /// Of a group that is advanced elsewhere: it need not be here.
  void setElsewhere(std::size_t g) { known_until_[g] = std::numeric_limits<double>::infinity(); }

  void findKnown(std::size_t g, const std::vector<WrenchSchedule>& schedules) {
    known_until_[g] = groups_[g].knownUntil(schedules);
  }

  /// The same of a group that may be at rest.
  void findKnownOrRest(std::size_t g, const std::vector<WrenchSchedule>& schedules) {
    known_until_[g] = knownOrRest(groups_[g], schedules);
  }

  /// Of all groups, those too that are removed; see Simulation. The magnification is looked for
  /// only where an integrator has claim kFeedsLeastAxis.
  int maxSubsteps() const;
  double magnification() const;
  std::int64_t evaluations() const;
  double work() const;

 private:
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  void erase(std::size_t g);
  static double workOf(const Group& group) {
    return static_cast<double>(group.evaluations()) * static_cast<double>(group.members().size());
  }
  static double knownOrRest(const Group& group, const std::vector<WrenchSchedule>& schedules) {
    return group.isAtRest() ? group.restsUntil(schedules) : group.knownUntil(schedules);
  }

  std::vector<Group> groups_;
  std::vector<double> known_until_;     // Group's, index by index
  std::vector<std::size_t> group_of_;   // body -> index in groups_; ignored for a fixed body
  std::vector<std::size_t> member_of_;  // body -> index among the members of its group; else kNone
  bool feeds_least_axis_ = false;       // whether an integrator of any group since clear() does
  Counts removed_;
};

}  // namespace rigid_body_sim
