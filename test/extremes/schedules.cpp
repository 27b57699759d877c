#include <algorithm>
#include <map>
#include <random>

#include "sections.hpp"

namespace rigid_body_sim::extremes {
namespace {

constexpr double kDuration = 1;  // [s] binary steps, so that events may lie on their ends

/// A sphere of 1 kg and 1 kg m² at rest: force and torque of fixed directions make it move as two
/// points on two lines.
test::Bench restingSphere() {
  test::Bench bench;
  bench.add(test::principalBody("ball", 1, Vector3d::Ones()), BodyFrameMotion());
  return bench;
}

/// Speed and way, gained from piecewise constant accelerations.
struct Line {
  reference::Real a = 0, v = 0, x = 0;
  void advance(reference::Real dt) {
    x += (v + a * dt / 2) * dt;
    v += a * dt;
  }
};

Ends closedForm(const test::Bench& bench) {
  std::map<double, std::pair<reference::Real, reference::Real>> changes;
  for (const PointWrench& w : bench.world.wrenches) {
    if (!(w.end > w.start)) continue;
    changes[w.start].first += w.force.x();
    changes[w.start].second += w.torque.z();
    changes[w.end].first -= w.force.x();
    changes[w.end].second -= w.torque.z();
  }
  changes[kDuration];
  Line along, about;
  double t = 0;
  for (const auto& [instant, change] : changes) {
    along.advance(static_cast<reference::Real>(instant) - t);
    about.advance(static_cast<reference::Real>(instant) - t);
    t = instant;
    along.a += change.first;
    about.a += change.second;
  }
  reference::Motion m;
  m.x = {along.x, 0, 0};
  m.v = {along.v, 0, 0};
  m.w = {0, 0, about.v};
  m.q = Quaternion<reference::Real>(std::cos(about.x / 2), 0, 0, std::sin(about.x / 2));
  return {{m}};
}

/// Entries from start(k) to end(k), each pushing and twisting by up to most [N, N m].
template <class Start, class End>
test::Bench scheduled(int entries, double most, const Start& start, const End& end) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0.5 * most, most);
  test::Bench bench = restingSphere();
  for (int k = 0; k < entries; ++k) {
    PointWrench push;
    push.force = {uniform(random), 0, 0};
    push.torque = {0, 0, uniform(random)};
    push.start = start(k);
    push.end = end(k);
    bench.world.wrenches.push_back(push);
  }
  return bench;
}

}  // namespace

Cells schedules(const Names& integrators, int entries) {
  const double share = kDuration / entries;
  const auto quarter = [](int) { return 0.25; };
  const auto three_quarters = [](int) { return 0.75; };
  const auto turn = [share](int k) { return share * k; };
  const auto next_turn = [share](int k) { return share * (k + 1); };
  // all act at once for an instant, so that the work grows with the square of their number
  const int few = std::max(1, entries / 50);
  const double few_share = kDuration / few;
  const auto early = [few_share](int k) { return few_share * k / 2; };
  const auto late = [few_share](int k) { return 0.5 + few_share * k / 2; };
  const std::vector<std::pair<std::string, test::Bench>> benches{
      {"back to back", scheduled(entries, 1, turn, next_turn)},
      {"same instants", scheduled(entries, 1.0 / entries, quarter, three_quarters)},
      {"zero length", scheduled(entries, 1.0 / entries, quarter, quarter)},
      {"all overlap (a 50th of them)", scheduled(few, 1.0 / few, early, late)}};
  Cells cells;
  for (const auto& [setting, bench] : benches)
    measureAll({"schedule", setting, ""}, integrators, bench, {kDuration / 128, 128},
               closedForm(bench), cells);
  return cells;
}

}  // namespace rigid_body_sim::extremes
