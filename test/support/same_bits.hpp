#pragma once

#include <array>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/simulation.hpp>

/// States that agree to the last bit, the signs of zeros included.
namespace rigid_body_sim::test {

/// All numbers of a state.
inline std::array<double, 19> numbersOf(const BodyState& s) {
  std::array<double, 19> numbers{};
  double* to = numbers.data();
  for (const Vector3d* v : {&s.x_W, &s.x_low_W, &s.p_W, &s.L_W, &s.L_P})
    for (int i = 0; i < 3; ++i) *to++ = (*v)(i);
  for (int i = 0; i < 4; ++i) *to++ = s.q_WP.coeffs()(i);
  return numbers;
}

inline bool sameBits(const BodyState& a, const BodyState& b) {
  const auto of_a = numbersOf(a), of_b = numbersOf(b);
  return std::memcmp(of_a.data(), of_b.data(), sizeof of_a) == 0;
}

/// Of all bodies of two runs.
inline void expectSameBodies(const Simulation& a, const Simulation& b) {
  ASSERT_EQ(a.steps(), b.steps());
  for (std::size_t i = 0; i < a.world().bodies.size(); ++i)
    ASSERT_TRUE(sameBits(a.body(i), b.body(i))) << "body " << i << " after step " << a.steps();
}

/// And of what the runs have counted.
inline void expectSameBits(const Simulation& a, const Simulation& b) {
  EXPECT_EQ(a.evaluations(), b.evaluations());
  EXPECT_EQ(a.magnification(), b.magnification());
  EXPECT_EQ(a.maxSubsteps(), b.maxSubsteps());
  expectSameBodies(a, b);
}

/// Of all bodies at once, by two threads, and of each by itself.
inline void expectBodiesReadByTwoThreads(World world, const State& start,
                                         const std::string& integrator) {
  world.solver.threads = 2;
  world.solver.integrator = integrator;
  world.solver.time_step = 0.01;
  Simulation simulation(std::move(world), start);
  simulation.step(3);
  const std::vector<BodyState> states = simulation.bodies();
  for (std::size_t i = 0; i < states.size(); ++i)
    ASSERT_TRUE(sameBits(states[i], simulation.body(i))) << integrator << ", body " << i;
}

}  // namespace rigid_body_sim::test
