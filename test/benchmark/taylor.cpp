#include <string>
#include <vector>

#include <benchmark/benchmark.h>

#include <rigid_body_sim/mass/shapes.hpp>

#include "dynamics/taylor/taylor_segment.hpp"
#include "support/random_bodies.hpp"

// The cost of Taylor segments: one by kind of wrench, with and without a look at its end; a change
// of wrench; and the whole of a box under a world force at a body point.

namespace rigid_body_sim {
namespace {

const Vector3d kGravity(0, 0, -9.81);

Body boxBody() { return makeBody("box", massProperties(Box{{1, 0.5, 0.25}}, 2)); }

BodyState turning(const Body& body) {
  BodyState state;
  state.L_P = body.I.cwiseProduct(Vector3d(1, 2, 1.5));
  state.L_W = rotate(state.q_WP, state.L_P);
  return state;
}

HeldWrench held(const PointWrench& applied) {
  HeldWrenchSum sum;
  sum.add(applied);
  return sum.sum();
}

HeldWrench kindOfWrench(const std::string& kind) {
  PointWrench applied;
  applied.force = Vector3d(1, 2, 12);
  applied.point = Vector3d(0.3, -0.1, 0.05);
  HeldWrench wrench;
  if (kind == "world torque") wrench.tau_W = Vector3d(0.1, 0.2, 0.3);
  if (kind == "body torque") wrench.tau_P = Vector3d(0.1, 0.2, 0.3);
  if (kind == "thruster") applied.axes = 0;
  if (kind == "pull") applied.point_frame = kWorld;
  const bool at_point = kind == "lever" || kind == "thruster" || kind == "pull";
  return at_point ? held(applied) : wrench;
}

void buildSegment(benchmark::State& run, const std::string& kind) {
  const Body body = boxBody();
  const BodyState start = turning(body);
  const HeldWrench wrench = kindOfWrench(kind);
  for (auto _ : run)
    benchmark::DoNotOptimize(TaylorSegment(body, wrench, kGravity, start).validFor());
}

void evaluateSegment(benchmark::State& run, const std::string& kind) {
  const Body body = boxBody();
  const TaylorSegment segment(body, kindOfWrench(kind), kGravity, turning(body));
  for (auto _ : run) benchmark::DoNotOptimize(segment.at(0.5 * segment.validFor()));
}

/// 1000 wrenches, each held for 10 ms.
void changeWrench(benchmark::State& run, bool body_axes) {
  Draw draw(3);
  const Body body = boxBody();
  std::vector<HeldWrench> wrenches(1000);
  for (HeldWrench& wrench : wrenches) {
    PointWrench applied;
    applied.axes = body_axes ? 0 : kWorld;
    applied.force = draw.vector(10);
    applied.point = draw.vector(0.3);
    applied.torque = draw.vector(1);
    wrench = held(applied);
  }
  for (auto _ : run) {
    BodyState state = turning(body);
    for (const HeldWrench& wrench : wrenches)
      state = advanceTaylor(body, wrench, kGravity, state, 0.01);
    benchmark::DoNotOptimize(state);
  }
  run.SetItemsProcessed(run.iterations() * 1000);
}

/// The box starts at rest and is driven for 10 s.
void driveBox(benchmark::State& run) {
  const Body body = boxBody();
  const HeldWrench wrench = kindOfWrench("lever");
  for (auto _ : run)
    benchmark::DoNotOptimize(advanceTaylor(body, wrench, kGravity, BodyState(), 10.0));
}

BENCHMARK_CAPTURE(buildSegment, free, "free");
BENCHMARK_CAPTURE(buildSegment, world_torque, "world torque");
BENCHMARK_CAPTURE(buildSegment, body_torque, "body torque");
BENCHMARK_CAPTURE(buildSegment, lever, "lever");
BENCHMARK_CAPTURE(buildSegment, thruster, "thruster");
BENCHMARK_CAPTURE(buildSegment, pull, "pull");
BENCHMARK_CAPTURE(evaluateSegment, free, "free");
BENCHMARK_CAPTURE(evaluateSegment, lever, "lever");
BENCHMARK_CAPTURE(evaluateSegment, thruster, "thruster");
BENCHMARK_CAPTURE(changeWrench, world_axes, false);
BENCHMARK_CAPTURE(changeWrench, body_axes, true);
BENCHMARK(driveBox);

}  // namespace
}  // namespace rigid_body_sim

BENCHMARK_MAIN();
