#include <limits>

#include <gtest/gtest.h>

#include "scene_texts.hpp"

namespace rigid_body_sim {
namespace {

Imu imuOf(const std::string& keys) {
  return parseScene(boxScene("    imus: {imu: {" + keys + "}}\n"), "s.yaml").bodies[0].imus[0].imu;
}

std::string imuError(const std::string& keys) {
  return boxError("    imus: {imu: {" + keys + "}}\n");
}

const std::string kImu = kAtBox + "imus.imu";

}  // namespace

TEST(ImuKeys, HaveDefaults) {
  const Imu imu = imuOf("rate: 200");
  EXPECT_EQ(imu.name, "imu");
  EXPECT_EQ(imu.position_B, Vector3d::Zero());
  EXPECT_EQ(imu.q_BS.coeffs(), Quaterniond::Identity().coeffs());
  EXPECT_EQ(imu.rate, 200);
  EXPECT_EQ(imu.seed, 0U);
  for (const SensorNoise& noise : {imu.gyroscope, imu.accelerometer}) {
    EXPECT_EQ(noise.density, 0);
    EXPECT_EQ(noise.bias, Vector3d::Zero());
    EXPECT_EQ(noise.bias_walk, 0);
  }
}

TEST(ImuKeys, AreRead) {
  const Imu imu = imuOf(
      "position: [1, 2, 3], orientation: [0, 0, 1, 0], rate: 333.5, seed: 18446744073709551615, "
      "gyroscope: {noise_density: 1e-4, bias: [4, 5, 6], bias_walk: 1e-6}, "
      "accelerometer: {noise_density: 2e-3, bias: [7, 8, 9], bias_walk: 3e-5}");
  EXPECT_EQ(imu.position_B, Vector3d(1, 2, 3));
  EXPECT_EQ(imu.q_BS.coeffs(), Quaterniond(0, 0, 0, 1).coeffs());
  EXPECT_EQ(imu.rate, 333.5);
  EXPECT_EQ(imu.seed, std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(imu.gyroscope.density, 1e-4);
  EXPECT_EQ(imu.gyroscope.bias, Vector3d(4, 5, 6));
  EXPECT_EQ(imu.gyroscope.bias_walk, 1e-6);
  EXPECT_EQ(imu.accelerometer.density, 2e-3);
  EXPECT_EQ(imu.accelerometer.bias, Vector3d(7, 8, 9));
  EXPECT_EQ(imu.accelerometer.bias_walk, 3e-5);
}

TEST(ImuKeys, SayWhichRuleTheyBreak) {
  EXPECT_EQ(imuError("seed: 1"), kAtBox + "missing key 'imus.imu.rate'");
  EXPECT_EQ(imuError("rate: 0"), kImu + ".rate must be > 0 Hz, got 0");
  EXPECT_EQ(imuError("rate: -5"), kImu + ".rate must be > 0 Hz, got -5");
  EXPECT_EQ(imuError("rate: 2e6"), kImu + ".rate must be > 0 and at most 1e6 Hz, got 2e6");
  const std::string seed_rule = ".seed must be a whole number from 0 to 2^64 - 1, got ";
  for (const std::string bad : {"-1", "1.5", "1e3", "18446744073709551616", "one"})
    EXPECT_EQ(imuError("rate: 1, seed: " + bad), kImu + seed_rule + bad);
  EXPECT_EQ(imuError("rate: 1, gyroscope: {noise_density: -1e-4}"),
            kImu + ".gyroscope.noise_density must be >= 0 rad/s/sqrt(Hz), got -1e-4");
  EXPECT_EQ(imuError("rate: 1, gyroscope: {bias_walk: -2}"),
            kImu + ".gyroscope.bias_walk must be >= 0 rad/s^2/sqrt(Hz), got -2");
  EXPECT_EQ(
      imuError("rate: 1, accelerometer: {noise_density: .nan}"),
      kImu + ".accelerometer.noise_density must be a finite number [m/s^2/sqrt(Hz)], got .nan");
  EXPECT_EQ(imuError("rate: 1, accelerometer: {bias_walk: -2}"),
            kImu + ".accelerometer.bias_walk must be >= 0 m/s^3/sqrt(Hz), got -2");
  EXPECT_NE(imuError("rate: 1, accelerometer: {bias: [1, 2]}").find(kImu + ".accelerometer.bias"),
            std::string::npos);
  EXPECT_NE(imuError("rate: 1, orientation: [0, 0, 0, 2]").find(kImu + ".orientation"),
            std::string::npos);
  EXPECT_NE(imuError("rate: 1, noise: 3").find("unknown key 'imus.imu.noise'"), std::string::npos);
  EXPECT_NE(
      imuError("rate: 1, gyroscope: {density: 3}").find("unknown key 'imus.imu.gyroscope.density'"),
      std::string::npos);
}

TEST(ImuKeys, AreAMappingOfNames) {
  EXPECT_EQ(boxError("    imus: [{rate: 1}]\n").find(kAtBox + "imus must be a mapping"), 0U);
  EXPECT_EQ(boxError("    imus: {1st: {rate: 1}}\n").find(kAtBox + "imus: '1st' must be a name"),
            0U);
}

TEST(ImuNames, DifferFromPointsAndFromTheTopicsOfTheBody) {
  EXPECT_EQ(boxError("    imus:\n      tip: {rate: 1}\n    points: {tip: {}}\n"),
            "s.yaml:7: body 'box': imus.tip: name is taken, by the point on line 8");
  for (const std::string name :
       {"odom", "wrench", "command", "actuators", "applied_wrench", "accel", "pivot_force"})
    EXPECT_EQ(boxError("    imus: {" + name + ": {rate: 1}}\n"),
              kAtBox + "imus." + name + ": the topic box/" + name +
                  " is the body's own; an IMU needs a name other than accel, actuators, "
                  "applied_wrench, command, odom, pivot_force, wrench");
  // of different bodies they may be alike
  EXPECT_EQ(boxError("    imus: {imu: {rate: 1}}\n  - {name: ball, shape: {sphere: {radius: 1}}, "
                     "mass: 1, imus: {imu: {rate: 1}}}\n"),
            "");
}

TEST(Imus, OfASceneArePartOfItsWorld) {
  const World world = buildWorld(parseScene(
      boxScene("    imus: {a: {rate: 1}, b: {rate: 2}}\n  - {name: ball, shape: {sphere: {radius: "
               "1}}, mass: 1, fixed: true, imus: {c: {rate: 3}}}\nforces:\n  - {type: "
               "central_gravity, center: [1, 2, 3], mu: 4}\n"),
      "s.yaml"));
  ASSERT_EQ(world.imus.size(), 3U);
  EXPECT_EQ(world.imus[1].name, "b");
  EXPECT_EQ(world.imus[1].body, 0U);
  EXPECT_EQ(world.imus[2].body, 1U);
  EXPECT_EQ(world.imus[2].rate, 3);
  ASSERT_EQ(world.gravity_centers.size(), 1U);
  EXPECT_EQ(world.gravity_centers[0].center_W, Vector3d(1, 2, 3));
  EXPECT_EQ(world.gravity_centers[0].mu, 4);
}

TEST(Imus, OfAFixedBodyMustNotLieAtACentreOfGravity) {
  const std::string text = boxScene(
      "    position: [1, 0, 0]\n    fixed: true\n    imus: {imu: {position: [0, 2, 0], rate: 1}}\n"
      "forces: [{type: central_gravity, center: [1, 2, 0], mu: 4}]\n");
  EXPECT_EQ(errorOf(text),
            "s.yaml:8: body 'box': imus.imu lies at a center of central_gravity, where gravity is "
            "infinite; move its position");
}

}  // namespace rigid_body_sim
