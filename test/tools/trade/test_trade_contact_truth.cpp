#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/contact_twins.hpp"
#include "tools/trade/trade_contact.hpp"

/// What `trade` reports of contact, beside an independent reference, which shares nothing with it.
namespace rigid_body_sim {
namespace {

using test::ContactTwin;

constexpr double kTwinBudget = 1e-6;
constexpr Patience kNoTiming{0, 0};

/// What the independent reference and the rounding of its states leave: measured, 1.5e-14.
constexpr double kTwinRounding = 1e-13;

/// As a scene that states a tolerance, so that its rows are of runs with a trial before them.
void solveByAuto(World& world, double horizon) {
  world.solver.integrator = "auto";
  world.solver.time_step = 0.001;
  world.solver.horizon = horizon;
  world.solver.tolerance = 1e-5;
  world.solver.tolerance_stated = true;
}

std::vector<Setting> ladderOf(const World& world, const Reference& reference) {
  std::vector<Setting> settings;
  climbTolerances(
      world, reference, "auto", [&](const Setting& s) { settings.push_back(s); }, kNoTiming);
  return settings;
}

/// Returns whether `trade` could tell the error from its own doubt.
bool expectTrue(double reported, double real, double doubt, const std::string& which) {
  const bool is_resolved = reported > 2 * doubt && reported > kTwinRounding;
  if (is_resolved) {
    EXPECT_LT(reported, 2 * real) << which;
    EXPECT_GT(reported, real / 2) << which;
  } else {
    EXPECT_LT(real, 3 * std::max(doubt, kTwinRounding)) << which;
  }
  return is_resolved;
}

void expectTrueErrors(ContactTwin twin, double duration) {
  World& world = twin.bench.world;
  solveByAuto(world, duration);
  const Reference reference = contactReference(world, twin.bench.initial, duration, kTwinBudget);
  EXPECT_GE(reference.known_until, duration);
  Reference truth = reference;
  truth.states = twin.track(duration, static_cast<int>(reference.states.size()) - 1);
  const std::vector<Setting> reported = ladderOf(world, reference), real = ladderOf(world, truth);
  ASSERT_EQ(reported.size(), real.size());
  int told = 0;
  for (std::size_t i = 0; i < real.size(); ++i) {
    const Errors &said = reported[i].errors, &is = real[i].errors;
    const std::string at = " at " + std::to_string(std::log10(real[i].tolerance));
    told += expectTrue(said.attitude, is.attitude, reference.doubt.attitude, "attitude" + at);
    told += expectTrue(said.position, is.position, reference.doubt.position, "position" + at);
    EXPECT_LT(is.bounded(), real[i].tolerance);
  }
  EXPECT_GT(told, 4);
}

TEST(TradeContactTruth, IsReportedOfABouncingBall) { expectTrueErrors(test::bouncingBall(), 1); }
TEST(TradeContactTruth, IsReportedOfALandingBox) { expectTrueErrors(test::landingBox(), 0.5); }
TEST(TradeContactTruth, IsReportedOfASlidingBox) { expectTrueErrors(test::slidingBox(), 0.08); }
TEST(TradeContactTruth, IsReportedOfARollingBall) { expectTrueErrors(test::rollingBall(), 0.4); }

// A deviation of 1e-12 m grows a billionfold: no digit of a long run can be known.
TEST(TradeContactTruth, IsReportedAsLostOfATumblingBox) {
  constexpr double kTumblingTime = 4;
  ContactTwin twin = test::tumblingBox();
  World& world = twin.bench.world;
  solveByAuto(world, kTumblingTime);
  world.solver.time_step = 0.01;
  const Reference reference =
      contactReference(world, twin.bench.initial, kTumblingTime, kTwinBudget);
  const int intervals = static_cast<int>(reference.states.size()) - 1;
  const std::vector<State> truth = twin.track(kTumblingTime, intervals);
  twin.start[0].x[2] += 1e-12L;
  const std::vector<State> beside = twin.track(kTumblingTime, intervals);
  const auto apart = [&](const std::vector<State>& track) { return errorsOf(world, track, truth); };
  EXPECT_GT(apart(beside).bounded(), 100 * kTwinBudget);

  EXPECT_LT(reference.known_until, 0.9 * kTumblingTime);
  EXPECT_GT(reference.known_until, 0.5 * kTumblingTime);
  // up to then it is the truth, within a factor of two
  std::vector<State> known = reference.states;
  for (std::size_t k = 0; k < known.size(); ++k)
    if (known[k].t > reference.known_until) known[k] = truth[k];
  EXPECT_LT(apart(known).bounded(), 2 * kTwinBudget);
}

}  // namespace
}  // namespace rigid_body_sim
