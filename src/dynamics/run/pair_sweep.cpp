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

/// Some times as far as from one state to another.
Roam roamTo(const BodyState& from, const BodyState& to, double times) {
  return {from, times * distanceBetween(from, to),
          std::min(times * angleBetween(from.q_WP, to.q_WP), kHalfTurn)};
}

/// Of the bodies of a group that is integrated and does not stop on its way, such as on springs:
/// how fast it will be is not known, so that a copy goes there.
std::vector<Roam> triedRoams(const Group& group, const std::vector<double>& radius, double t,
                             double t_end, std::vector<WrenchSchedule> schedules) {
  // Of an oscillation as fast as one a step, four looks see cos(45°) of the greatest distance at
  // least: 1.42 times what was seen, and some more. Faster ones may escape: a margin, not a bound.
  constexpr int kLooks = 4;
  constexpr double kFurther = 1.6;
  constexpr double kSlack = 0.02;  // of the radius, and in rad: for what is seen to stand still
  const std::vector<std::size_t>& members = group.members();
  std::vector<Roam> roams;
  for (std::size_t k = 0; k < members.size(); ++k)
    roams.push_back({group.at(t, k), kSlack * std::max(radius[members[k]], 0.0), kSlack});
  Group copy = group;
  try {
    for (int look = 1; look <= kLooks; ++look) {
      const double to = t + (t_end - t) * look / kLooks;
      copy.advance(copy.time(), to, schedules);
      copy.accept(to);
      for (std::size_t k = 0; k < members.size(); ++k) {
        const Roam tried = roamTo(roams[k].from, copy.present().bodies[k], kFurther);
        roams[k].place = std::max(roams[k].place, tried.place);
        roams[k].turn = std::max(roams[k].turn, tried.turn);
      }
    }
  } catch (const StepTooLong&) {
    for (Roam& roam : roams) roam = {roam.from, kUnbounded, kHalfTurn};
  }
  return roams;
}

/// Of the bodies of a group whose motion is known, or that stops where a body goes further.
std::vector<Roam> roamsOf(const Group& group, const World& world, const std::vector<double>& radius,
                          double t, double t_end, const std::vector<WrenchSchedule>& schedules) {
  const std::optional<MotionBound> bound = group.motionBound(schedules);
  std::vector<Roam> roams;
  for (std::size_t k = 0; k < group.members().size(); ++k) {
    const std::size_t body = group.members()[k];
    const Body& of = world.bodies[body];
    const BodyState s = group.at(t, k);
    if (!group.isSolvedAhead())
      roams.push_back(watchedRoam(of, s, world.g_W.norm(), std::max(radius[body], 0.0), t_end - t));
    else if (bound && bound->until >= t_end)
      roams.push_back(boundedRoam(of, s, *bound, t_end - t));
    else
      roams.push_back({s, kUnbounded, kHalfTurn});
  }
  return roams;
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
  // a body of no such law may go anywhere
  if (hasLaws()) roams_.assign(world.bodies.size(), {BodyState(), kUnbounded, kUnbounded});
}

void PairSweep::sweep(const World& world, const Groups& groups,
                      const std::vector<WrenchSchedule>& schedules, double time, double t_end,
                      bool looks_ahead) {
  looked_ahead_ = looks_ahead && groups.allSolvedAhead();
  until_ = looked_ahead_ ? std::max(t_end, time + window_) : t_end;
  for (const Group& group : groups.all()) {
    const std::vector<std::size_t>& members = group.members();
    const auto isOfPair = [this](std::size_t body) { return table_->radius[body] >= 0; };
    if (std::none_of(members.begin(), members.end(), isOfPair)) continue;
    const double t = std::max(time, group.time());
    const std::vector<Roam> roams =
        group.isSolvedAhead() || group.mayStop()
            ? roamsOf(group, world, table_->radius, t, until_, schedules)
            : triedRoams(group, table_->radius, t, until_, schedules);
    for (std::size_t k = 0; k < members.size(); ++k)
      if (isOfPair(members[k])) roams_[members[k]] = roams[k];
  }
  const std::size_t before = candidates_.size();
  findCandidates();
  // as far ahead as costs few candidates
  const bool few = candidates_.size() <= before + groups.size() / 4;
  if (looked_ahead_) window_ = few ? 2 * (until_ - time) : 0.5 * (until_ - time);
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
