#include <cstring>
#include <utility>

#include <gtest/gtest.h>

#include "dynamics/packs/block_lane.hpp"
#include "dynamics/packs/read_block.hpp"
#include "support/many_bodies.hpp"
#include "support/random_bodies.hpp"
#include "support/same_bits.hpp"

// Every width gives the bits of one body at a time.

namespace rigid_body_sim {
namespace {

using test::packedIntegrators;

struct Blocks {
  PackLoad load;
  std::vector<PackBlock> blocks;
  std::vector<PushBlock> pushes;

  std::size_t lanes() const { return blocks.size() * PackBlock::kLanes; }
  void step(const PackKernels& kernels, PackKind kind, const double* h, int count,
            std::size_t bodies) {
    kernels.step(kind, load)(h, count, blocks.data(), pushes.data(), bodies);
  }
};

bool sameBlocks(const Blocks& a, const Blocks& b, std::size_t count) {
  return std::memcmp(a.blocks.data(), b.blocks.data(), count * sizeof(PackBlock)) == 0;
}

/// With load a wrench of each kind, at every other body a force at a point of it; drag of which
/// one part or another is missing.
Blocks blocksOf(const test::Bench& bench, const std::string& integrator, PackKind kind, double h,
                PackLoad load) {
  Blocks all{load, {}, {}};
  std::size_t count = 0;
  Draw draw(3);
  for (std::size_t i = 0; i < bench.world.bodies.size(); ++i) {
    const Body& body = bench.world.bodies[i];
    const Method& method = methodNamed(integrator);
    HeldWrench held;
    held.f_W = draw.vector(1);
    if (load != PackLoad::kNone) {
      held.f_P = draw.vector(1);
      held.tau_W = draw.vector(0.1);
      held.tau_P = draw.vector(0.1);
      if (i % 2 == 0) held.body_point_forces.push_back({draw.vector(0.1), draw.vector(1)});
    }
    const Drag drag(i, {i % 3 ? 0.3 : 0, i % 4 < 2 ? 0.2 : 0, i % 5 ? 0.1 : 0});
    SteadyMotion motion{&body, &method, method.max_turn, body.mass * bench.world.g_W, &held};
    if (load == PackLoad::kDrag) motion.drag = &drag;
    if (packKindOf(motion) != kind) continue;
    const std::size_t lane = count++ % PackBlock::kLanes;
    if (lane == 0) all.blocks.push_back(emptyBlock());
    if (lane == 0 && load != PackLoad::kNone) all.pushes.push_back({});
    putBody(motion, kind, h, bench.initial.bodies[i], all.blocks.back(), lane);
    PushBlock none{};
    EXPECT_EQ(putPush(motion, h, load == PackLoad::kNone ? none : all.pushes.back(), lane), load);
  }
  return all;
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

constexpr PackLoad kLoads[]{PackLoad::kNone, PackLoad::kPush, PackLoad::kDrag};

TEST(PackKernels, GiveTheSameBitsAtEveryWidth) {
  const test::Bench bench = test::thrownBodies(240);
  ASSERT_GE(packKernels().size(), 2u);
  ASSERT_EQ(packKernels().front().lanes, 1u);
  for (const PackLoad load : kLoads)
    for (const auto& [integrator, kind] : kKinds) {
      const Blocks start = blocksOf(bench, integrator, kind, 0.01, load);
      ASSERT_GE(start.blocks.size(), 2u) << integrator;
      Blocks one_by_one = start;
      one_by_one.step(packKernels().front(), kind, stepLengths(), 50, start.lanes());
      ASSERT_FALSE(sameBlocks(one_by_one, start, 1));
      for (const PackKernels& kernels : packKernels()) {
        Blocks packed = start;
        packed.step(kernels, kind, stepLengths(), 50, start.lanes());
        EXPECT_TRUE(sameBlocks(packed, one_by_one, start.blocks.size()))
            << integrator << ", " << kernels.lanes << " lanes " << kernels.instructions;
      }
    }
}

TEST(PackKernels, TakeSeveralStepsAsOneByOne) {
  const test::Bench bench = test::thrownBodies(200);
  for (const PackLoad load : kLoads)
    for (const auto& [integrator, kind] : kKinds)
      for (const PackKernels& kernels : packKernels()) {
        Blocks at_once = blocksOf(bench, integrator, kind, 0.01, load);
        Blocks singly = at_once;
        at_once.step(kernels, kind, stepLengths(), 9, at_once.lanes());
        for (int k = 0; k < 9; ++k)
          singly.step(kernels, kind, stepLengths() + k, 1, at_once.lanes());
        EXPECT_TRUE(sameBlocks(at_once, singly, at_once.blocks.size())) << integrator;
      }
}

TEST(PackKernels, LeaveBodiesAloneThatAreNotAsked) {
  for (const PackLoad load : kLoads) {
    const Blocks start = blocksOf(test::thrownBodies(40), "rk4", PackKind::kRk4, 0.01, load);
    for (const PackKernels& kernels : packKernels()) {
      Blocks stepped = start;
      stepped.step(kernels, PackKind::kRk4, stepLengths(), 3, PackBlock::kLanes);
      EXPECT_FALSE(sameBlocks(stepped, start, 1));
      EXPECT_EQ(std::memcmp(&stepped.blocks[1], &start.blocks[1], sizeof(PackBlock)), 0);
    }
  }
}

/// The states lie in another order than the bodies.
TEST(PackKernels, AllBodiesOfABlockAreReadAsOneByOne) {
  const Blocks all =
      blocksOf(test::thrownBodies(240), "rk4", PackKind::kRk4, 0.01, PackLoad::kNone);
  constexpr std::size_t kLanes = PackBlock::kLanes;
  std::vector<BodyState> states(kLanes + 1);
  BodyState* to[kLanes];
  for (std::size_t k = 0; k < kLanes; ++k) to[k] = &states[(5 * k + 3) % (kLanes + 1)];
  for (const ReadBlock read : {readBlock(), ReadBlock(readBlockNarrow)}) {
    read(all.blocks[1], to);
    for (std::size_t k = 0; k < kLanes; ++k)
      EXPECT_TRUE(test::sameBits(*to[k], bodyIn(all.blocks[1], k))) << k;
  }
  EXPECT_TRUE(test::sameBits(states[(5 * kLanes + 3) % (kLanes + 1)], BodyState()));
}

TEST(PackKernels, FewBodiesTakeNoMoreLanesThanTheyNeed) {
  EXPECT_EQ(packKernelsFor(1).lanes, 1u);
  EXPECT_EQ(packKernelsFor(2).lanes, 2u);
  EXPECT_EQ(packKernelsFor(1000).lanes, packKernels().back().lanes);
}

}  // namespace
}  // namespace rigid_body_sim
