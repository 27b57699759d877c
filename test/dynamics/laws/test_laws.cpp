#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/drag.hpp>

#include "support/law_cases.hpp"

namespace rigid_body_sim {
namespace {

using test::Bench;
using test::LawCase;
using test::LawPointer;
using test::Pair;
using test::Placement;

constexpr unsigned kPairs = 50;

Vector3d torque(const Wrench& wrench, const BodyState& state) {
  return wrench.tau_W + rotate(state.q_WP, wrench.tau_P);
}

/// Σ f · v + τ · ω
double power(const Pair& pair, const std::vector<Wrench>& wrenches) {
  double sum = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const BodyState& s = pair.states[i];
    const Vector3d w_W = rotate(s.q_WP, angularVelocity(pair.bodies[i].inv_I, s.L_P));
    sum += wrenches[i].f_W.dot(s.p_W) / pair.bodies[i].mass + torque(wrenches[i], s).dot(w_W);
  }
  return sum;
}

class EveryLaw : public testing::TestWithParam<LawCase> {};

INSTANTIATE_TEST_SUITE_P(Laws, EveryLaw, testing::ValuesIn(test::everyLaw()),
                         [](const auto& tested) { return std::string(tested.param.name); });

// Central differences over dt = 1e-5 s: dt² times a third derivative of some 1e2 J/s³, and the
// rounding of energies of some 1e2 J over dt.
TEST_P(EveryLaw, PowerIsMinusTheRateOfItsPotentialAndWhatItDissipates) {
  const LawPointer law = GetParam().make(Placement());
  const std::vector<double> own = Pair::ownOf(*law, GetParam());
  constexpr double dt = 1e-5;
  for (unsigned seed = 0; seed < kPairs; ++seed) {
    const Pair pair(seed);
    const double V_rate =
        (pair.movedOn(dt).potentialEnergy(*law) - pair.movedOn(-dt).potentialEnergy(*law)) /
        (2 * dt);
    const double external = pair.externalPower(*law, own);
    const double expected = -V_rate + external;
    EXPECT_NEAR(power(pair, pair.wrenches(*law, own)), expected, 1e-7 * (1 + std::abs(expected)));
    EXPECT_EQ((law->needs() & kDamping) != 0, GetParam().damped);
    if (GetParam().damped && !GetParam().driven) {
      EXPECT_LT(external, 0);
    }
  }
}

// Rounding of attitudes and of places some 10 m from the origin.
TEST_P(EveryLaw, ActsTheSameInASceneThatIsTurnedMovedOrMirrored) {
  const LawPointer here = GetParam().make(Placement());
  const std::vector<double> own = Pair::ownOf(*here, GetParam());
  for (const Placement& scene : test::everyPlacement()) {
    const LawPointer there = GetParam().make(scene);
    const std::vector<double> own_there = Pair::ownOf(*there, GetParam());
    for (unsigned seed = 0; seed < kPairs; ++seed) {
      const Pair pair(seed), placed = pair.placed(scene);
      const auto w = pair.wrenches(*here, own), w_placed = placed.wrenches(*there, own_there);
      for (std::size_t i = 0; i < 2; ++i) {
        const double size = 1 + w[i].f_W.norm();
        EXPECT_LE((scene.vector(w[i].f_W) - w_placed[i].f_W).norm(), 1e-13 * size);
        EXPECT_LE((scene.spin(torque(w[i], pair.states[i])) - torque(w_placed[i], placed.states[i]))
                      .norm(),
                  1e-13 * size);
      }
      const double power_here = pair.externalPower(*here, own);
      EXPECT_NEAR(power_here, placed.externalPower(*there, own_there),
                  1e-13 * (1 + std::abs(power_here)));
      // of buoyancy, as of gravity, up to what the place of the scene's origin adds
      const double level = placed.potentialEnergy(*there) - pair.potentialEnergy(*here);
      const double level_of_first =
          Pair(0).placed(scene).potentialEnergy(*there) - Pair(0).potentialEnergy(*here);
      EXPECT_NEAR(level, level_of_first, 2e-13 * (1 + std::abs(pair.potentialEnergy(*here))));
    }
  }
}

TEST_P(EveryLaw, NamesTheBodiesItActsOnAndFollowsTheirNewIndices) {
  const LawPointer law = GetParam().make(Placement());
  const std::vector<double> own = Pair::ownOf(*law, GetParam());
  const LawPointer swapped = law->reindexed([](std::size_t body) { return 1 - body; });
  const Pair pair(1);
  Pair crossed = pair;
  std::swap(crossed.bodies[0], crossed.bodies[1]);
  std::swap(crossed.states[0], crossed.states[1]);
  const auto w = pair.wrenches(*law, own), w_crossed = crossed.wrenches(*swapped, own);
  const auto members = law->members();
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(w[i].f_W, w_crossed[1 - i].f_W);
    EXPECT_EQ(w[i].tau_P, w_crossed[1 - i].tau_P);
    const bool named = std::find(members.begin(), members.end(), i) != members.end();
    EXPECT_EQ(w[i].f_W != Vector3d::Zero(), named);
  }
}

// Forces to the last bit; moments about the origin to the rounding of 1 m × 1e2 N.
TEST(Spring, PullsItsEndsEquallyAndOppositely) {
  const Spring spring({0, {0.3, -0.2, 0.5}}, {1, {-0.1, 0.4, 0.2}}, {40, 3, 0.7});
  for (unsigned seed = 0; seed < kPairs; ++seed) {
    const Pair pair(seed);
    const auto w = pair.wrenches(spring);
    EXPECT_EQ(w[0].f_W, -w[1].f_W);
    Vector3d moment = Vector3d::Zero();
    for (std::size_t i = 0; i < 2; ++i)
      moment += pair.states[i].x_W.cross(w[i].f_W) + torque(w[i], pair.states[i]);
    EXPECT_LE(moment.norm(), 1e-13 * (1 + w[0].f_W.norm()));
  }
}

TEST(Spring, PullsNothingWhereItsEndsMeet) {
  Pair pair(3);
  pair.states[1].x_W = pair.states[0].x_W;
  pair.states[1].x_low_W = pair.states[0].x_low_W;
  const auto w = pair.wrenches(Spring({0, Vector3d::Zero()}, {1, Vector3d::Zero()}, {40, 3, 0.7}));
  EXPECT_EQ(w[0].f_W, Vector3d::Zero());
  EXPECT_EQ(w[1].tau_P, Vector3d::Zero());
}

// A stretch of 1e-6 m at 1e8 m from the origin: the positions' low parts count.
TEST(Spring, KeepsItsDigitsFarFromTheOrigin) {
  Pair pair(4);
  pair.states[0].x_W = pair.states[1].x_W = Vector3d(1e8, 0, 0);
  pair.states[1].x_low_W = Vector3d(1e-9, 0, 0);
  pair.states[0].x_low_W = Vector3d(-1e-9, 0, 0);
  const auto w = pair.wrenches(Spring({0, Vector3d::Zero()}, {1, Vector3d::Zero()}, {1e6, 0, 0}));
  EXPECT_NEAR(w[0].f_W.x(), 2e-3, 1e-17);
}

TEST(Drag, DissipatesWhatItsWrenchSays) {
  for (unsigned seed = 0; seed < kPairs; ++seed) {
    const Pair pair(seed);
    const Drag drag(seed % 2, {0.7, 0.3, 0.2});
    const double external = pair.externalPower(drag);
    EXPECT_LT(external, 0);
    EXPECT_NEAR(power(pair, pair.wrenches(drag)), external, -1e-13 * external);
  }
}

/// The end of a kick over h by many kicks.
BodyState kickedFinely(const Drag& drag, const Body& body, const Wrench& wrench, double h,
                       BodyState state) {
  constexpr int kKicks = 20000;
  for (int i = 0; i < kKicks; ++i) drag.kick(body, wrench, h / kKicks, state);
  return state;
}

// Of quadratic drag, the mean speed leaves (h/n)²; against it, forces of every direction.
TEST(Drag, FlowsAsItsEquationSays) {
  Draw draw(7);
  for (int k = 0; k < 20; ++k) {
    const Body body = draw.box(0.5);
    const double quadratic = k % 2 ? draw.uniform(0, 2) : 0;
    const Drag drag(0, {draw.uniform(0, 2), quadratic, draw.uniform(0, 0.1)});
    const BodyState start = draw.state(body, 3);
    Wrench wrench;
    wrench.f_W = k % 3 ? draw.vector(10) : Vector3d(-4 * start.p_W);
    wrench.tau_P = draw.vector(1);
    BodyState once = start;
    drag.kick(body, wrench, 0.01, once);
    const BodyState finely = kickedFinely(drag, body, wrench, 0.01, start);
    // exact without quadratic drag; else h³ times rates of up to some 10/s each
    const double tolerance = quadratic > 0 ? 2e-4 : 1e-12;
    EXPECT_LE((once.p_W - finely.p_W).norm(), tolerance * (1 + start.p_W.norm())) << k;
    EXPECT_LE((once.L_P - finely.L_P).norm(), 1e-12 * (1 + start.L_P.norm())) << k;
    // the very rate at the start
    std::vector<Wrench> force{wrench};
    const std::vector<const Body*> bodies{&body};
    const std::vector<BodyState> states{start};
    drag.addWrenches({bodies, states}, force);
    BodyState shortly = start;
    drag.kick(body, wrench, 1e-7, shortly);
    EXPECT_LE(((shortly.p_W - start.p_W) / 1e-7 - force[0].f_W).norm(), 2e-5) << k;
  }
}

TEST(MechanicalEnergy, SumsMotionGravityAndEveryLaw) {
  Bench bench;
  bench.world.g_W = {0, 0, -10};
  BodyFrameMotion motion = test::tumbling({3, 0, 0}, {0, 2, 0});
  motion.x_W = {0, 0, 5};
  bench.add(test::principalBody("a", 2, {1, 1.5, 2}), motion);
  bench.add(test::principalBody("fixed", 100, {1, 1, 1}), motion);
  bench.world.bodies[1].fixed = true;
  bench.addSpring({kWorld, {0, 4, 5}}, {0, Vector3d::Zero()}, {10, 0, 1});
  bench.addCentralGravity(0, {0, 0, 3}, 6, false);
  // ½ 2 3² + ½ 1.5 2² + 2 10 5 + ½ 10 (4 − 1)² − 6 2/2
  EXPECT_NEAR(mechanicalEnergy(bench.world, bench.initial), 9 + 3 + 100 + 45 - 6, 1e-12);
}

}  // namespace
}  // namespace rigid_body_sim
