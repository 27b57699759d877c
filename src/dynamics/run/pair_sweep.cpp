#include "dynamics/run/pair_sweep.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "dynamics/contact/overlapping_spheres.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr double kHalfTurn = 2;  // [rad] moves no point further than a turn by more does

/// Of a body whose motion is known to be within bounds.
Roam boundedRoam(const Body& body, const BodyState& state, const MotionBound& bound, double h) {
  const double least_I = 1 / body.inv_I.maxCoeff();
  const double a = bound.a_W.norm() + bound.a_off;
  const double spin = (state.L_P.norm() + bound.torque * h) / least_I;
  return {state, h * (state.p_W.norm() / body.mass + 0.5 * h * a), std::min(h * spin, kHalfTurn)};
}

/// Of a body that is integrated: faster than it is, and a little more, so that it is seldom left.
Roam watchedRoam(const Body& body, const BodyState& state, double g, double radius, double h) {
  constexpr double kFaster = 1.6, kSlack = 0.02;
  const double v = state.p_W.norm() / body.mass;
  const double w = angularVelocity(body.inv_I, state.L_P).norm();
  return {state, kFaster * h * (v + h * g) + kSlack * radius,
          std::min(kFaster * h * w + kSlack, kHalfTurn)};
}

}  // namespace

PairSweep::PairSweep(const World& world, const LawTable& laws) {
  Table table;
  table.radius.assign(world.bodies.size(), -1);
  for (std::size_t law : laws.ofPairs()) {
    const std::vector<std::size_t> members = world.laws[law]->members();
    for (std::size_t k = 0; k < members.size(); ++k)
      table.radius[members[k]] =
          std::max(table.radius[members[k]], world.laws[law]->touchRadius(k));
    const auto pair = std::minmax(members.front(), members.back());
    table.laws.push_back({pair.first, pair.second, law});
  }
  std::sort(table.laws.begin(), table.laws.end(), [](const PairLaw& x, const PairLaw& y) {
    return std::tie(x.a, x.b, x.law) < std::tie(y.a, y.b, y.law);
  });
  table_ = std::make_shared<const Table>(std::move(table));
  if (hasLaws()) roams_.resize(world.bodies.size());
}

void PairSweep::sweep(const World& world, const Groups& groups,
                      const std::vector<WrenchSchedule>& schedules, double time, double t_end) {
  until_ = t_end;
  const bool all_foreseen = std::all_of(groups.all().begin(), groups.all().end(),
                                        [](const Group& group) { return group.isForeseen(); });
  if (all_foreseen) until_ = std::max(t_end, time + window_);
  for (std::size_t body = 0; body < world.bodies.size(); ++body) {
    if (table_->radius[body] < 0) continue;
    const Group& group = groups.of(body);
    const double t = std::max(time, group.time()), h = until_ - t;
    const BodyState s = groups.at(body, t);
    const Body& of = world.bodies[body];
    const std::optional<MotionBound> bound = group.motionBound(schedules);
    if (!group.isForeseen())
      roams_[body] = watchedRoam(of, s, world.g_W.norm(), table_->radius[body], h);
    else if (bound && bound->until >= until_)
      roams_[body] = boundedRoam(of, s, *bound, h);
    else
      roams_[body] = {s, kUnbounded, kHalfTurn};
  }
  const std::size_t before = candidates_.size();
  findCandidates();
  // as far ahead as costs few candidates
  const bool few = candidates_.size() <= before + groups.size() / 4;
  if (all_foreseen) window_ = few ? 2 * (until_ - time) : 0.5 * (until_ - time);
}

void PairSweep::findCandidates() {
  std::vector<BoundingSphere> spheres(roams_.size());
  for (std::size_t body = 0; body < roams_.size(); ++body) {
    const Roam& roam = roams_[body];
    const double radius = table_->radius[body];
    spheres[body] = {roam.from.x_W + roam.from.x_low_W, radius < 0 ? -1 : radius + roam.place};
  }
  candidates_.clear();
  const auto isBefore = [](const PairLaw& x, const PairLaw& y) {
    return std::tie(x.a, x.b) < std::tie(y.a, y.b);
  };
  for (const auto& pair : overlappingSpheres(spheres)) {
    const auto laws = std::equal_range(table_->laws.begin(), table_->laws.end(),
                                       PairLaw{pair.first, pair.second, 0}, isBefore);
    for (auto law = laws.first; law != laws.second; ++law) candidates_.push_back(law->law);
  }
  std::sort(candidates_.begin(), candidates_.end());
}

}  // namespace rigid_body_sim
