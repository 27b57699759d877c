#include <limits>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/describe_solution.hpp>

#include "support/motor_benches.hpp"

/// What is no motor.
namespace rigid_body_sim {
namespace {

using namespace test;

std::string faultWith(const Actuator& actuator) {
  return actuatorsFault({actuator}, Vector3d(1, 2, 3).asDiagonal());
}

}  // namespace

TEST(Actuator, FaultsAreNamed) {
  Thruster thruster;
  EXPECT_EQ(faultWith(named("main", thruster)), "");
  thruster.direction_B = {0, 0, 2};
  EXPECT_EQ(faultWith(named("main", thruster)),
            "actuator 'main': direction must be of unit length");
  EXPECT_EQ(faultWith(named("main", thrusterAt({0, 0, 0}, {0, 0, 1}, 1e-10))),
            "actuator 'main': time_constant must be 0 or from 1e-9 to 1e9 s");
  Rotor rotor = rotorAt({0, 0, 0}, 1);
  rotor.time_constant = 0;
  EXPECT_EQ(faultWith(named("r", rotor)),
            "actuator 'r': with inertia, time_constant must be > 0 s: else the body's angular "
            "velocity would jump");
  rotor.inertia = 0;
  EXPECT_EQ(faultWith(named("r", rotor)), "");
  EXPECT_EQ(faultWith(named("w", wheelAlong({1, 0, 0}, 0))),
            "actuator 'w': inertia must be > 0 kg m^2 and finite");
  EXPECT_EQ(
      faultWith(named("w", wheelAlong({1, 0, 0}, 1.5))),
      "its inertia, which includes wheels and rotors, must be positive definite without theirs "
      "about their axes, got a least principal moment of -0.5 kg m^2");
  Actuator limited = named("w", wheelAlong({1, 0, 0}, 0.5));
  limited.least = 1;
  limited.greatest = -1;
  EXPECT_EQ(faultWith(limited), "actuator 'w': limits must be two numbers that ascend");
  const std::string alike = "actuator 'w': limits must not both be infinite alike";
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  limited.least = limited.greatest = kInfinity;
  EXPECT_EQ(faultWith(limited), alike);
  limited.least = limited.greatest = -kInfinity;
  EXPECT_EQ(faultWith(limited), alike);
  limited.greatest = kInfinity;
  EXPECT_EQ(faultWith(limited), "");
  EXPECT_EQ(actuatorsFault({named("a", Thruster()), named("a", Wheel(wheelAlong({1, 0, 0}, 0.1)))},
                           Matrix3d::Identity()),
            "actuator 'a': its name must be unique in its body and not empty");
}

TEST(Actuator, ReadingsAreOfStatesThatHaveThem) {
  const Bench bench = benchOf(motley(), motleyStart());
  const Simulation sim = bench.simulation("auto", 0.1);
  const Body& body = sim.world().bodies[0];
  const State now = sim.state();
  EXPECT_EQ(readActuators(body, now, 0).size(), body.actuators.size());
  State without = now;
  without.actuators.clear();
  EXPECT_THROW(readActuators(body, without, 0), std::invalid_argument);
  EXPECT_THROW(readActuators(body, now, 9), std::invalid_argument);
  EXPECT_THROW(readActuators(test::principalBody("bare", 1, {1, 1, 1}), now, 0),
               std::invalid_argument);
}

TEST(Actuator, BodiesWithFaultsAreRefused) {
  EXPECT_THROW(makeBody("box", {1, Vector3d::Zero(), Matrix3d::Identity()},
                        {named("w", wheelAlong({0, 1, 0}, 2))}),
               std::invalid_argument);
  Bench bench = benchOf(motley(), motleyStart());
  bench.world.bodies[0].fixed = true;
  try {
    bench.simulation("auto", 0.1);
    ADD_FAILURE();
  } catch (const std::invalid_argument& refused) {
    EXPECT_STREQ(refused.what(), "body 'body': it is fixed, motors cannot move it");
  }
}

TEST(Actuator, ADescriptionNamesMotors) {
  const Simulation sim = benchOf(quadrotor(), BodyFrameMotion()).simulation("auto", 0.1);
  EXPECT_EQ(describeSolution(sim).at(0), "body: gravity, motors, Taylor");
}

}  // namespace rigid_body_sim
