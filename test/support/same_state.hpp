#pragma once

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/simulation.hpp>

/// States that agree to the last bit in everything from which a run goes on.
namespace rigid_body_sim::test {

inline void expectSameBodyState(const BodyState& a, const BodyState& b) {
  EXPECT_EQ(a.x_W, b.x_W);
  EXPECT_EQ(a.x_low_W, b.x_low_W);
  EXPECT_EQ(a.q_WP.coeffs(), b.q_WP.coeffs());
  EXPECT_EQ(a.p_W, b.p_W);
  EXPECT_EQ(a.L_W, b.L_W);
  EXPECT_EQ(a.L_P, b.L_P);
}

inline void expectSameWrench(const ScheduledWrench& a, const ScheduledWrench& b) {
  EXPECT_EQ(a.slot, b.slot);
  EXPECT_EQ(a.wrench.body, b.wrench.body);
  EXPECT_EQ(a.wrench.axes, b.wrench.axes);
  EXPECT_EQ(a.wrench.point_frame, b.wrench.point_frame);
  EXPECT_EQ(a.wrench.force, b.wrench.force);
  EXPECT_EQ(a.wrench.torque, b.wrench.torque);
  EXPECT_EQ(a.wrench.point, b.wrench.point);
  EXPECT_EQ(a.wrench.at_center, b.wrench.at_center);
  EXPECT_EQ(a.wrench.start, b.wrench.start);
  EXPECT_EQ(a.wrench.end, b.wrench.end);
}

inline void expectSameSchedule(const BodySchedule& a, const BodySchedule& b) {
  ASSERT_EQ(a.wrenches.size(), b.wrenches.size());
  for (std::size_t k = 0; k < a.wrenches.size(); ++k)
    expectSameWrench(a.wrenches[k], b.wrenches[k]);
  ASSERT_EQ(a.commands.size(), b.commands.size());
  for (std::size_t k = 0; k < a.commands.size(); ++k) {
    EXPECT_EQ(a.commands[k].body, b.commands[k].body);
    EXPECT_EQ(a.commands[k].actuator, b.commands[k].actuator);
    EXPECT_EQ(a.commands[k].value, b.commands[k].value);
    EXPECT_EQ(a.commands[k].start, b.commands[k].start);
    EXPECT_EQ(a.commands[k].end, b.commands[k].end);
  }
}

inline void expectSameActuator(const ActuatorState& a, const ActuatorState& b) {
  EXPECT_EQ(a.command, b.command);
  EXPECT_EQ(a.value, b.value);
  EXPECT_EQ(a.since, b.since);
  EXPECT_EQ(a.until, b.until);
  EXPECT_EQ(a.saturations, b.saturations);
}

inline void expectSamePlan(const MotionPlan& a, const MotionPlan& b) {
  EXPECT_EQ(a.bodies, b.bodies);
  EXPECT_EQ(a.laws, b.laws);
  EXPECT_EQ(a.waiting_laws, b.waiting_laws);
  EXPECT_EQ(a.integrator, b.integrator);
  EXPECT_EQ(a.substeps, b.substeps);
  EXPECT_EQ(a.by_estimates, b.by_estimates);
  EXPECT_EQ(a.at_rest, b.at_rest);
  EXPECT_EQ(a.holds, b.holds);
  EXPECT_EQ(a.error, b.error);
  EXPECT_EQ(a.tried_until, b.tried_until);
  EXPECT_EQ(a.cut_short, b.cut_short);
}

inline void expectSameState(const State& a, const State& b) {
  EXPECT_EQ(a.t, b.t);
  ASSERT_EQ(a.bodies.size(), b.bodies.size());
  for (std::size_t i = 0; i < a.bodies.size(); ++i) expectSameBodyState(a.bodies[i], b.bodies[i]);
  EXPECT_EQ(a.laws, b.laws);
  ASSERT_EQ(a.actuators.size(), b.actuators.size());
  for (std::size_t i = 0; i < a.actuators.size(); ++i) {
    ASSERT_EQ(a.actuators[i].size(), b.actuators[i].size());
    for (std::size_t k = 0; k < a.actuators[i].size(); ++k)
      expectSameActuator(a.actuators[i][k], b.actuators[i][k]);
  }
  ASSERT_EQ(a.schedules.size(), b.schedules.size());
  for (std::size_t i = 0; i < a.schedules.size(); ++i)
    expectSameSchedule(a.schedules[i], b.schedules[i]);
  ASSERT_EQ(a.anchors.size(), b.anchors.size());
  for (std::size_t i = 0; i < a.anchors.size(); ++i) {
    EXPECT_EQ(a.anchors[i].t, b.anchors[i].t);
    EXPECT_EQ(a.anchors[i].horizon, b.anchors[i].horizon);
    expectSameBodyState(a.anchors[i].state, b.anchors[i].state);
  }
  ASSERT_EQ(a.plans.size(), b.plans.size());
  for (std::size_t i = 0; i < a.plans.size(); ++i) expectSamePlan(a.plans[i], b.plans[i]);
  EXPECT_EQ(a.near_laws, b.near_laws);
  EXPECT_EQ(a.changes, b.changes);
}

/// What a change of a run is refused with, which leaves all of its state; empty if it is not.
template <class Change>
std::string refusalThatChangesNothing(Simulation& sim, Change change) {
  const State before = sim.state();
  try {
    change();
  } catch (const std::invalid_argument& refused) {
    expectSameState(sim.state(), before);
    return refused.what();
  }
  return "";
}

/// A run taken up from its own state after that many steps has the bits of the whole, 50 steps on.
inline void expectToGoOnTheSame(Simulation whole, const std::vector<std::int64_t>& cuts) {
  for (std::int64_t cut : cuts) {
    SCOPED_TRACE(cut);
    while (whole.steps() < cut) whole.step();
    Simulation rest(whole.world(), whole.state());
    Simulation copy = whole;
    for (int i = 0; i < 50; ++i) {
      copy.step();
      rest.step();
    }
    expectSameState(rest.state(), copy.state());
  }
}

}  // namespace rigid_body_sim::test
