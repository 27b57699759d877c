#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

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
