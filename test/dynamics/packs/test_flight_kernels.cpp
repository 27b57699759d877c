#include <gtest/gtest.h>

#include "dynamics/packs/flight_kernels.hpp"
#include "dynamics/run/run.hpp"
#include "support/many_bodies.hpp"
#include "support/same_bits.hpp"

// Free flights that are evaluated several at a time have the bits of one by one, at every width.

namespace rigid_body_sim {
namespace {

/// Of boxes and of bodies with equal moments; about e₁ and about e₃.
std::vector<FreeFlight> thrownFlights(std::size_t count) {
  const test::Bench bench = test::thrownBodies(count);
  std::vector<FreeFlight> flights;
  for (std::size_t i = 0; i < count; ++i) {
    const Body& body = bench.world.bodies[i];
    flights.emplace_back(body, Vector3d(1, -2, -9.81 * body.mass), bench.initial.bodies[i]);
  }
  return flights;
}

double timeOf(std::size_t i) { return i % 7 == 0 ? 1e5 + 0.1 : 0.01 * static_cast<double>(i + 1); }

void expectBits(const BodyState& a, const BodyState& b, const std::string& where) {
  EXPECT_TRUE(test::sameBits(a, b)) << where;
}

TEST(FlightKernels, GiveTheSameBitsAtEveryWidth) {
  ASSERT_GE(flightKernels().size(), 2u);
  ASSERT_EQ(flightKernels().front().lanes, 1u);
  const std::vector<FreeFlight> flights = thrownFlights(150);
  int of_axis[2]{};
  for (const FreeFlight& flight : flights)
    if (const ThetaRotation* theta = flight.rotation().asTheta()) ++of_axis[theta->axis() / 2];
  ASSERT_GT(of_axis[0], 20);
  ASSERT_GT(of_axis[1], 20);
  for (const FlightKernels& kernels : flightKernels()) {
    FlightBatch batch(kernels);
    std::vector<BodyState> states(flights.size());
    for (std::size_t i = 0; i < flights.size(); ++i) batch.read(flights[i], timeOf(i), states[i]);
    batch.finish();
    for (std::size_t i = 0; i < flights.size(); ++i)
      expectBits(states[i], flights[i].at(timeOf(i)),
                 std::to_string(kernels.lanes) + " lanes " + kernels.instructions);
  }
}

TEST(FlightKernels, GiveTheSameBitsToAnyNumberOfBodies) {
  const std::vector<FreeFlight> flights = thrownFlights(40);
  for (std::size_t count = 1; count <= flights.size(); ++count) {
    FlightBatch batch;
    std::vector<BodyState> states(count);
    for (std::size_t i = 0; i < count; ++i) batch.read(flights[i], timeOf(i), states[i]);
    batch.finish();
    batch.finish();  // nothing is left
    for (std::size_t i = 0; i < count; ++i)
      expectBits(states[i], flights[i].at(timeOf(i)), "of " + std::to_string(count));
  }
}

TEST(FlightKernels, FewBodiesTakeNoMoreLanesThanTheyNeed) {
  EXPECT_EQ(flightKernelsFor(1).lanes, 1u);
  EXPECT_EQ(flightKernelsFor(2).lanes, 2u);
  EXPECT_EQ(flightKernelsFor(1000).lanes, flightKernels().back().lanes);
}

TEST(FlightKernels, ReadARunAsOneByOne) {
  test::Bench bench = test::thrownBodies(30);
  bench.world.bodies[4].fixed = true;
  bench.initial.bodies[4].p_W = bench.initial.bodies[4].L_W = bench.initial.bodies[4].L_P =
      Vector3d::Zero();
  PointWrench turn = test::worldForce({1, -2, 3}, 0.033, 0.055);
  turn.torque = {0.1, 0.2, -0.1};
  turn.body = turn.point_frame = 7;
  bench.world.wrenches.push_back(turn);
  bench.addSpring({11, {0.1, 0, 0}}, {12, {-0.1, 0, 0}}, {10, 0, 0.8});
  Simulation simulation = bench.simulation("auto", 0.01);
  std::vector<BodyState> states;
  for (int k = 0; k < 10; ++k) {
    simulation.readBodies(states);
    ASSERT_EQ(states.size(), 30u);
    for (std::size_t i = 0; i < 30; ++i)
      expectBits(states[i], simulation.body(i),
                 "body " + std::to_string(i) + " after step " + std::to_string(k));
    if (k == 5) simulation.setState(20, simulation.body(0));
    simulation.step(k % 2 + 1);
  }
}

}  // namespace
}  // namespace rigid_body_sim
