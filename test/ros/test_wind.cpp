#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/inputs/wind_interface.hpp"

namespace rigid_body_sim {
namespace {

Simulation inAir(const std::string& medium) {
  const Scene scene = parseScene("time_step: 0.01\n" + medium +
                                     "bodies:\n  - {name: leaf, shape: {sphere: {radius: 0.1}}, "
                                     "mass: 0.5, drag: {linear: 0.5}}\n",
                                 "test");
  const World world = buildWorld(scene);
  return Simulation(world, initialState(scene, world));
}

geometry_msgs::Vector3Stamped windOf(double x, const std::string& frame) {
  geometry_msgs::Vector3Stamped message;
  message.header.frame_id = frame;
  message.vector.x = x;
  return message;
}

/// Why a wind is refused; empty where it is not.
std::string windFault(Simulation& sim, const geometry_msgs::Vector3Stamped& message) {
  const State before = sim.state();
  try {
    sim.apply(takeWind(message, "map"));
  } catch (const std::invalid_argument& refused) {
    EXPECT_EQ(sim.state().laws, before.laws);
    return refused.what();
  }
  return "";
}

}  // namespace

// v = w (1 − exp(−l t/m)) with l/m = 1/s
TEST(Wind, BlowsFromTheMessageOn) {
  Simulation sim = inAir("medium: {}\n");
  while (sim.steps() < 100) sim.step();
  EXPECT_EQ(sim.body(0).p_W.x(), 0);
  EXPECT_EQ(windFault(sim, windOf(3, "map")), "");
  while (sim.steps() < 200) sim.step();
  EXPECT_NEAR(sim.body(0).p_W.x() / 0.5, -3 * std::expm1(-1.0), 1e-14);
  sim.reset(false);
  while (sim.steps() < 300) sim.step();
  EXPECT_EQ(sim.body(0).p_W.x(), 0);
}

TEST(Wind, IsRefusedInOneLine) {
  Simulation sim = inAir("medium: {}\n"), still = inAir("");
  EXPECT_EQ(windFault(sim, windOf(3, "leaf")),
            "header.frame_id must be the world frame 'map', got 'leaf'");
  EXPECT_EQ(windFault(sim, windOf(3, "")), "header.frame_id must be the world frame 'map', got ''");
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()})
    EXPECT_EQ(windFault(sim, windOf(bad, "map")),
              std::string("the velocity of the wind must be finite, got [") +
                  (std::isnan(bad) ? "nan" : "inf") + " 0 0] m/s");
  EXPECT_EQ(windFault(still, windOf(3, "map")), "wind needs a medium, and the scene names none");
}

}  // namespace rigid_body_sim
