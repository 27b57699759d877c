#include <cmath>
#include <functional>
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

TEST(Arguments, AreNumbersOfSteps) {
  EXPECT_EQ(askRefusal([](Simulation& sim) { sim.step(-1); }),
            "a number of steps must be >= 0, got -1");
}

}  // namespace
}  // namespace rigid_body_sim
