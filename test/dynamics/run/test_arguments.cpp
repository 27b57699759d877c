#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/step_sampler.hpp>

#include "support/worlds.hpp"

/// What a simulation is asked with an index or a time that is out of range is refused.
namespace rigid_body_sim {
namespace {

std::string askRefusal(const std::function<void(Simulation&)>& ask) {
  Simulation sim = test::restingBox().simulation("auto", 0.1);
  sim.step();
  try {
    ask(sim);
  } catch (const std::invalid_argument& refused) {
    EXPECT_EQ(sim.steps(), 1);
    return refused.what();
  }
  return "answered";
}

TEST(Arguments, AreIndicesOfBodies) {
  const std::string no_body = "no body has the index 1";
  PointWrench on_none;
  on_none.body = 1;
  EXPECT_EQ(askRefusal([](Simulation& sim) { sim.body(0); }), "answered");
  EXPECT_EQ(askRefusal([](Simulation& sim) { sim.body(1); }), no_body);
  EXPECT_EQ(askRefusal([](Simulation& sim) { sim.motions({0, 1}, 0.1); }), no_body);
  EXPECT_EQ(askRefusal([](Simulation& sim) { sim.wrenchCount(1); }), no_body);
  EXPECT_EQ(askRefusal([](Simulation& sim) { sim.activeWrenches(1); }), no_body);
  EXPECT_EQ(askRefusal([](Simulation& sim) { sim.activeWrenches(1, 0.1); }), no_body);
  EXPECT_EQ(askRefusal([](Simulation& sim) { sim.appliedWrench(1); }), no_body);
  EXPECT_EQ(askRefusal([](Simulation& sim) { sim.actuators(1); }), no_body);
  EXPECT_EQ(askRefusal([&](Simulation& sim) { sim.replaces("slot", on_none); }), no_body);
}

TEST(Arguments, OfASamplerAreThoseOfItsSimulation) {
  EXPECT_EQ(askRefusal([](Simulation& sim) {
              StepSampler(sim).motions({0, 1}, 0.1);
            }),
            "no body has the index 1");
  for (double rate : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_THROW(StatesWithin{rate}, std::invalid_argument) << rate;
}

TEST(Arguments, OfAFixedBodyAreWithoutVelocity) {
  test::Bench bench = test::restingBox();
  bench.world.bodies[0].fixed = true;
  EXPECT_NO_THROW(bench.simulation("auto", 0.1));
  for (Vector3d BodyState::*momentum : {&BodyState::p_W, &BodyState::L_W, &BodyState::L_P}) {
    test::Bench moving = bench;
    moving.initial.bodies[0].*momentum = {0, 0, 2};
    EXPECT_THROW(moving.simulation("auto", 0.1), std::invalid_argument);
  }
}

TEST(Arguments, AreCentersOfGravity) {
  const auto accepts = [](const GravityCenter& center) {
    test::Bench bench = test::restingBox();
    bench.world.gravity_centers = {center};
    try {
      bench.simulation("auto", 0.1);
    } catch (const std::invalid_argument&) {
      return false;
    }
    return true;
  };
  EXPECT_TRUE(accepts({{0, 0, -6.4e6}, 3.99e14}));
  EXPECT_FALSE(accepts({{0, std::nan(""), 0}, 1}));
  for (double mu : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_FALSE(accepts({{0, 0, 0}, mu})) << mu;
}

/// A steady pull, which says nothing of what it needs.
class SilentPull final : public ForceLaw {
 public:
  const char* name() const override { return "pull"; }
  std::vector<std::size_t> members() const override { return {0}; }
  std::shared_ptr<const ForceLaw> reindexed(
      const std::function<std::size_t(std::size_t)>&) const override {
    return std::make_shared<SilentPull>();
  }
  unsigned needs() const override { return 0; }
  void addWrenches(const Bodies&, std::vector<Wrench>& wrenches) const override {
    wrenches[0].f_W.x() += 10;
  }
  double potentialEnergy(const Bodies& at) const override { return -10 * at.states[0].x_W.x(); }
  double externalPower(const Bodies&) const override { return 0; }
};

// A body under it would be solved as if nothing acted.
TEST(Arguments, AreLawsThatNeedSomething) {
  test::Bench bench = test::restingBox();
  bench.world.laws.push_back(std::make_shared<SilentPull>());
  try {
    bench.simulation("auto", 0.1);
    ADD_FAILURE() << "accepted";
  } catch (const std::invalid_argument& refused) {
    EXPECT_NE(std::string(refused.what()).find("law 'pull': it must need"), std::string::npos)
        << refused.what();
  }
}

TEST(Arguments, AreTimesWithinTheNextStep) {
  for (double t : {0.1, 0.15, 0.2, std::nextafter(0.1, 0.0), std::nextafter(0.2, 1.0)}) {
    EXPECT_EQ(askRefusal([t](Simulation& sim) { sim.sample(t); }), "answered") << t;
    EXPECT_EQ(askRefusal([t](Simulation& sim) { sim.motions({0}, t); }), "answered") << t;
  }
  for (double t : {0.09, 0.21, std::nan("")}) {
    const auto refusals = {askRefusal([t](Simulation& sim) { sim.sample(t); }),
                           askRefusal([t](Simulation& sim) { sim.motions({0}, t); }),
                           askRefusal([t](Simulation& sim) { sim.activeWrenches(0, t); })};
    for (const std::string& refusal : refusals)
      EXPECT_EQ(refusal.substr(0, refusal.find(", got")),
                "a time must be between now and the next step, from 0.1 to 0.2 s")
          << t;
  }
}

TEST(Arguments, AreWrenchesOfNumbers) {
  const auto refusal = [](const std::function<void(PointWrench&)>& change) {
    return askRefusal([&](Simulation& sim) {
      PointWrench push;
      change(push);
      sim.applyWrench("push", push);
    });
  };
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  const std::string on = "wrench on body 'box': ";
  EXPECT_EQ(refusal([](PointWrench&) {}), "answered");
  EXPECT_EQ(refusal([](PointWrench& push) { push.axes = 1; }), on + "no body has the index 1");
  EXPECT_EQ(refusal([](PointWrench& push) { push.point_frame = 1; }),
            on + "no body has the index 1");
  for (double x : {nan, inf}) {
    const std::string finite = on + "force, torque and point must be finite";
    EXPECT_EQ(refusal([x](PointWrench& push) { push.force.y() = x; }), finite);
    EXPECT_EQ(refusal([x](PointWrench& push) { push.torque.z() = x; }), finite);
    EXPECT_EQ(refusal([x](PointWrench& push) { push.point.x() = x; }), finite);
  }
  EXPECT_EQ(refusal([](PointWrench& push) {
              push.force = {0, 1.7e308, 1.7e308};
            }),
            on + "force must have a finite magnitude");
  EXPECT_EQ(refusal([](PointWrench& push) {
              push.torque = {1.7e308, 0, 1.7e308};
            }),
            on + "torque must have a finite magnitude");
  EXPECT_EQ(refusal([](PointWrench& push) {
              push.point = {1.7e308, 0, 1.7e308};
            }),
            on + "point must be at a finite distance");
  const auto far = [](PointWrench& push) {  // parallel: inf - inf in a cross product
    push.force = push.point = {0, 1e160, 1e160};
    push.torque.x() = 3;
  };
  EXPECT_NE(refusal(far).find(on + "the torque of the force must be finite, got 1.41"),
            std::string::npos)
      << refusal(far);
  const std::string times = on + "start must be finite, end a number";
  for (double start : {nan, inf, -inf})
    EXPECT_EQ(refusal([start](PointWrench& push) { push.start = start; }), times);
  EXPECT_EQ(refusal([nan](PointWrench& push) { push.end = nan; }), times);
  EXPECT_EQ(refusal([inf](PointWrench& push) { push.end = inf; }), "answered");
}

TEST(Arguments, AreNumbersOfSteps) {
  EXPECT_EQ(askRefusal([](Simulation& sim) { sim.step(-1); }),
            "a number of steps must be >= 0, got -1");
}

}  // namespace
}  // namespace rigid_body_sim
