#include <cstring>
#include <utility>

#include <gtest/gtest.h>

#include "dynamics/packs/block_lane.hpp"
#include "support/many_bodies.hpp"

// Every width gives the bits of one body at a time.

namespace rigid_body_sim {
namespace {

using test::packedIntegrators;

std::vector<PackBlock> blocksOf(const test::Bench& bench, const std::string& integrator,
                                PackKind kind, double h) {
  std::vector<PackBlock> blocks;
  std::size_t count = 0;
  for (std::size_t i = 0; i < bench.world.bodies.size(); ++i) {
    const Body& body = bench.world.bodies[i];
    const Method& method = methodNamed(integrator);
    const SteadyMotion motion{&body, &method, method.max_turn, body.mass * bench.world.g_W};
    if (packKindOf(motion) != kind) continue;
    if (count % PackBlock::kLanes == 0) blocks.push_back(emptyBlock());
    putBody(motion, kind, h, bench.initial.bodies[i], blocks.back(), count % PackBlock::kLanes);
    ++count;
  }
  return blocks;
}

/// [s] Lengths that differ by rounding, as those of steps do, and by more.
const double* stepLengths() {
  static const std::vector<double> lengths = [] {
    std::vector<double> h;
    for (int k = 0; k < 50; ++k) h.push_back((k + 1) * 0.01 - k * 0.01 + (k % 7 == 0 ? 1e-3 : 0));
    return h;
  }();
  return lengths.data();
}

const std::pair<const char*, PackKind> kKinds[]{
    {"semi_implicit_euler", PackKind::kSemiImplicitEuler},
    {"strang", PackKind::kStrang02},
    {"strang", PackKind::kStrang20},
    {"strang", PackKind::kStrang12},
    {"magnus4", PackKind::kMagnus4},
    {"rk4", PackKind::kRk4}};

TEST(PackKernels, GiveTheSameBitsAtEveryWidth) {
  const test::Bench bench = test::thrownBodies(120);
  ASSERT_GE(packKernels().size(), 2u);
  ASSERT_EQ(packKernels().front().lanes, 1u);
  for (const auto& [integrator, kind] : kKinds) {
    const std::vector<PackBlock> start = blocksOf(bench, integrator, kind, 0.01);
    ASSERT_GE(start.size(), 2u) << integrator;
    std::vector<PackBlock> one_by_one = start;
    const std::size_t count = start.size() * PackBlock::kLanes;
    packKernels().front().step(kind)(stepLengths(), 50, one_by_one.data(), count);
    ASSERT_NE(std::memcmp(one_by_one.data(), start.data(), sizeof(PackBlock)), 0);
    for (const PackKernels& kernels : packKernels()) {
      std::vector<PackBlock> packed = start;
      kernels.step(kind)(stepLengths(), 50, packed.data(), count);
      EXPECT_EQ(std::memcmp(packed.data(), one_by_one.data(), count / 8 * sizeof(PackBlock)), 0)
          << integrator << ", " << kernels.lanes << " lanes " << kernels.instructions;
    }
  }
}

TEST(PackKernels, TakeSeveralStepsAsOneByOne) {
  const test::Bench bench = test::thrownBodies(200);
  for (const auto& [integrator, kind] : kKinds)
    for (const PackKernels& kernels : packKernels()) {
      std::vector<PackBlock> at_once = blocksOf(bench, integrator, kind, 0.01);
      std::vector<PackBlock> singly = at_once;
      const std::size_t count = at_once.size() * PackBlock::kLanes;
      kernels.step(kind)(stepLengths(), 9, at_once.data(), count);
      for (int k = 0; k < 9; ++k) kernels.step(kind)(stepLengths() + k, 1, singly.data(), count);
      EXPECT_EQ(std::memcmp(at_once.data(), singly.data(), at_once.size() * sizeof(PackBlock)), 0)
          << integrator;
    }
}

TEST(PackKernels, LeaveBodiesAloneThatAreNotAsked) {
  const std::vector<PackBlock> start =
      blocksOf(test::thrownBodies(40), "rk4", PackKind::kRk4, 0.01);
  for (const PackKernels& kernels : packKernels()) {
    std::vector<PackBlock> blocks = start;
    kernels.step(PackKind::kRk4)(stepLengths(), 3, blocks.data(), PackBlock::kLanes);
    EXPECT_NE(std::memcmp(&blocks[0], &start[0], sizeof(PackBlock)), 0);
    EXPECT_EQ(std::memcmp(&blocks[1], &start[1], sizeof(PackBlock)), 0);
  }
}

TEST(PackKernels, FewBodiesTakeNoMoreLanesThanTheyNeed) {
  EXPECT_EQ(packKernelsFor(1).lanes, 1u);
  EXPECT_EQ(packKernelsFor(2).lanes, 2u);
  EXPECT_EQ(packKernelsFor(1000).lanes, packKernels().back().lanes);
}

}  // namespace
}  // namespace rigid_body_sim
