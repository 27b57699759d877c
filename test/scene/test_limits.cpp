#include <string>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "scene/limits.hpp"
#include "scene_texts.hpp"

namespace rigid_body_sim {
namespace {

std::string repeated(const std::string& text, std::size_t times) {
  std::string all;
  all.reserve(text.size() * times);
  for (std::size_t i = 0; i < times; ++i) all += text;
  return all;
}

/// A list of so many items that are none of what the list must hold.
std::string items(const std::string& key, std::size_t count) {
  return key + ":\n" + repeated("- 1\n", count);
}

}  // namespace

TEST(SceneLimit, IsOneOfBytesForATextToo) {
  EXPECT_EQ(errorOf(std::string(kMaxSceneBytes + 1, '#')), "s.yaml: is larger than 64 MiB");
}

TEST(SceneLimit, IsOneOfValues) {
  EXPECT_EQ(errorOf("gravity: [" + repeated("1,", kMaxValues - 2) + "]"),
            "s.yaml:1: missing key 'time_step'");
  EXPECT_EQ(errorOf("gravity:\n- [" + repeated("1,", kMaxValues) + "]"),
            "s.yaml:2: a scene must hold at most 8000000 values");
}

TEST(SceneLimit, IsOneOfBodies) {
  EXPECT_EQ(errorOf("time_step: 1\n" + items("bodies", kMaxBodies)),
            "s.yaml:3: bodies[0]: a mapping is expected, got 1");
  EXPECT_EQ(errorOf("time_step: 1\n" + items("bodies", kMaxBodies + 1)),
            "s.yaml:2: bodies must hold at most 200000 bodies, got 200001");
}

TEST(SceneLimit, IsOneOfLaws) {
  EXPECT_EQ(errorOf(boxScene(items("forces", kMaxForces + 1))),
            "s.yaml:6: forces must hold at most 200000 laws, got 200001");
}

TEST(SceneLimit, IsOneOfWrenches) {
  EXPECT_EQ(errorOf(boxScene(items("wrenches", Simulation::kMaxWrenches + 1))),
            "s.yaml:6: wrenches must hold at most 100000 wrenches, got 100001");
}

TEST(SceneLimit, IsOneOfThePointsOfABody) {
  std::string points = "    points:\n";
  for (std::size_t i = 0; i <= kMaxPoints; ++i) points += "      p" + std::to_string(i) + ": {}\n";
  EXPECT_EQ(errorOf(boxScene(points)),
            "s.yaml:6: body 'box': points must hold at most 10000 points, got 10001");
}

TEST(SceneLimit, IsOneOfTheLengthOfATextAndOfAKey) {
  const std::string longest(kMaxTextBytes, 'a');
  EXPECT_EQ(errorOf("integrator: " + longest + "a\n"),
            "s.yaml:1: a text must have at most 4096 bytes, got 4097");
  EXPECT_EQ(errorOf("? " + longest + "a\n: 1\n"),
            "s.yaml:1: a text must have at most 4096 bytes, got 4097");
  EXPECT_EQ(errorOf("world_frame: " + longest + "\n").find("a text must"), std::string::npos);
}

TEST(SceneLimit, IsOneOfTheLengthOfAName) {
  const auto named = [](std::size_t length) {
    return "time_step: 1\nbodies:\n- {name: " + std::string(length, 'a') +
           ", shape: {sphere: {radius: 1}}, mass: 1}\n";
  };
  EXPECT_EQ(errorOf(named(kMaxNameBytes)), "");
  EXPECT_EQ(errorOf(named(kMaxNameBytes + 1)),
            "s.yaml:3: bodies[0]: name must be a name [A-Za-z][A-Za-z0-9_]* of at most 255 bytes, "
            "got " +
                std::string(60, 'a') + "...");
}

TEST(SceneLimit, StopsABombOfAliases) {
  std::string bomb = "a: &a [x, x]\n";
  for (char c = 'b'; c <= 'z'; ++c)
    bomb += std::string(1, c) + ": &" + c + " [*" + char(c - 1) + ", *" + char(c - 1) + "]\n";
  EXPECT_EQ(errorOf(bomb), "s.yaml:1: YAML anchors (&) and aliases (*) are not allowed");
}

}  // namespace rigid_body_sim
