#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include "dynamics/methods/catalogue.hpp"
#include "support/contact_benches.hpp"

/// The normal law, and what is refused.
namespace rigid_body_sim {
namespace {

using test::Bench;
using test::contactOf;
using test::motionAt;

constexpr double kBallRadius = 0.1;

Bench strikingBall(double speed, const ContactParameters& parameters) {
  Bench bench;
  test::addBall(bench, kBallRadius, 0.7, motionAt({0, 0, 0.13}, {0, 0, -speed}), HalfSpace{},
                parameters);
  return bench;
}

// x (1 + e) = ln((1 + x)/(1 − e x)), solved with 50 digits.
TEST(Restitution, IsThatOfTheClosedForm) {
  EXPECT_NEAR(dissipationForRestitution(0.5, 1), 1.4327505332713750280527, 1e-15);
  EXPECT_NEAR(dissipationForRestitution(0.9, 1), 0.16648195068530806389927, 1e-16);
  EXPECT_NEAR(dissipationForRestitution(0.999, 1), 0.0015015013512010866244565, 1e-18);
  EXPECT_NEAR(dissipationForRestitution(0.5, 4), 1.4327505332713750280527 / 4, 1e-15);
  EXPECT_EQ(dissipationForRestitution(1, 3), 0);
}

TEST(Restitution, MustBeAboveZeroAndAtMostOne) {
  for (double e : {0.0, -0.1, 1.0000001, std::nan("")})
    EXPECT_THROW(dissipationForRestitution(e, 1), std::invalid_argument) << e;
  for (double v : {0.0, -1.0, std::nan(""), HUGE_VAL})
    EXPECT_THROW(dissipationForRestitution(0.5, v), std::invalid_argument) << v;
}

TEST(Restitution, IsWhatABallReboundsWith) {
  constexpr double kSpeed = 3;
  for (double p : {1.0, 1.5, 2.2}) {
    for (double e : {0.3, 0.5, 0.9, 1.0}) {
      const double d = dissipationForRestitution(e, kSpeed);
      Simulation sim =
          test::simulationAt(strikingBall(kSpeed, contactOf(1e6, p, d, 0)), 1e-10, 0.01);
      while (sim.time() < 0.2) sim.step();
      EXPECT_NEAR(sim.body(0).p_W.z() / 0.7, e * kSpeed, 1e-12) << p << ' ' << e;
    }
  }
}

// Depth at which all of the energy is in the spring: k δ^(p+1)/(p+1) = ½ m v².
TEST(NormalForce, StoresTheEnergyThatIsMissing) {
  constexpr double kSpeed = 2, k = 3e5, p = 1.5;
  Simulation sim = test::simulationAt(strikingBall(kSpeed, contactOf(k, p, 0, 0)), 1e-10, 1e-4);
  double deepest = 0;
  while (sim.time() < 0.04) {
    sim.step();
    for (const ContactPoint& contact : contactsOf(sim.world(), sim.state()))
      deepest = std::max(deepest, contact.penetration);
  }
  const double expected = std::pow((p + 1) / k * 0.5 * 0.7 * kSpeed * kSpeed, 1 / (p + 1));
  EXPECT_NEAR(deepest, expected, 1e-3 * expected);
}

TEST(Contact, IsRefusedByIntegratorsThatWouldLoseItsEvents) {
  const Bench bench = strikingBall(1, contactOf(1e5, 1.5, 0, 0.5));
  for (const Method& method : catalogue()) {
    if (std::string(method.name) == "dop853") {
      EXPECT_NO_THROW(bench.simulation(method.name, 0.01));
      continue;
    }
    try {
      bench.simulation(method.name, 0.01);
      FAIL() << method.name;
    } catch (const std::invalid_argument& refused) {
      EXPECT_EQ(
          std::string(refused.what()),
          "integrator must be auto or support contact, as body 'ball0' needs (dop853), got '" +
              std::string(method.name) + "'");
    }
  }
}

TEST(Contact, RefusesAStateOfWhichItsOwnAreNoNumbers) {
  const Bench bench = strikingBall(1, contactOf(1e5, 1.5, 0, 0.5));
  State state = bench.simulation("auto", 0.01).state();
  state.laws[0] = std::nan("");
  EXPECT_THROW(Simulation(bench.world, state), std::invalid_argument);
}

TEST(Contact, RefusesParametersThatBreakARule) {
  const Bench bench = strikingBall(1, contactOf(1e5, 1.5, 0, 0.5));
  const auto refuses = [&](auto change) {
    ContactParameters parameters = contactOf(1e5, 1.5, 0, 0.5);
    change(parameters);
    EXPECT_THROW(
        contactWithHalfSpace(bench.world.bodies, 0, test::ballShape(1), HalfSpace{}, parameters),
        std::invalid_argument);
  };
  refuses([](ContactParameters& c) { c.stiffness = 0; });
  refuses([](ContactParameters& c) { c.exponent = 0.9; });
  refuses([](ContactParameters& c) { c.dissipation = -1; });
  refuses([](ContactParameters& c) { c.friction = std::nan(""); });
  refuses([](ContactParameters& c) { c.breakaway = 0; });
  refuses([](ContactParameters& c) { c.rolling_friction = -1e-3; });
}

TEST(Contact, RefusesShapesThatCannotTouch) {
  Bench bench = strikingBall(1, contactOf(1e5, 1.5, 0, 0.5));
  bench.add(test::principalBody("other", 1, {1, 1, 1}), motionAt({1, 0, 0}));
  const ContactParameters c = contactOf(1e5, 1.5, 0, 0);
  const std::vector<Body>& bodies = bench.world.bodies;
  ContactShape point;
  point.points.push_back(Vector3d::Zero());
  const ContactShape ball = test::ballShape(1);
  EXPECT_THROW(contactWithHalfSpace(bodies, 0, ContactShape(), HalfSpace{}, c),
               std::invalid_argument);
  EXPECT_THROW(contactWithHalfSpace(bodies, 2, ball, HalfSpace{}, c), std::invalid_argument);
  EXPECT_THROW(contactWithHalfSpace(bodies, 0, test::ballShape(0), HalfSpace{}, c),
               std::invalid_argument);
  EXPECT_THROW(contactOfBalls(bodies, 0, ball, 1, point, c), std::invalid_argument);
  EXPECT_THROW(contactOfBalls(bodies, 0, ball, 0, ball, c), std::invalid_argument);
  for (double norm : {0.0, 2.0, std::nan("")}) {
    ContactShape egg;
    egg.ellipsoids.push_back({Vector3d::Zero(), Quaterniond(norm, 0, 0, 0), {3, 2, 1}});
    EXPECT_THROW(contactWithHalfSpace(bodies, 0, egg, HalfSpace{}, c), std::invalid_argument)
        << norm;
  }
}

TEST(Contact, RefusesPlanesOfWhatMoves) {
  Bench bench = strikingBall(1, contactOf(1e5, 1.5, 0, 0.5));
  Body post = test::principalBody("post", 1, {1, 1, 1});
  post.fixed = true;
  bench.add(post, motionAt({9, 0, 0}));
  const auto withPlaneOf = [&](std::size_t body) {
    HalfSpace plane;
    plane.body = body;
    return contactWithHalfSpace(bench.world.bodies, 0, test::ballShape(1), plane,
                                contactOf(1e5, 1.5, 0, 0));
  };
  EXPECT_NO_THROW(withPlaneOf(1));
  EXPECT_NO_THROW(withPlaneOf(kWorld));
  EXPECT_THROW(withPlaneOf(0), std::invalid_argument);  // itself, which moves
  EXPECT_THROW(withPlaneOf(2), std::invalid_argument);
}

TEST(Contact, RefusesASpeedForWhichDissipationIsBeyondNumbers) {
  EXPECT_GT(dissipationForRestitution(0.5, 1e-300), 1e299);
  EXPECT_THROW(dissipationForRestitution(0.5, 1e-320), std::invalid_argument);
}

}  // namespace
}  // namespace rigid_body_sim
