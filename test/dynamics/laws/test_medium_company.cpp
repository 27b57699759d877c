#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/contact.hpp>
#include <rigid_body_sim/dynamics/describe_solution.hpp>
#include <rigid_body_sim/dynamics/tether.hpp>

#include "support/law_cases.hpp"

/// Bodies in a medium that motors, tethers or contact act on, too: they are stepped.
namespace rigid_body_sim {
namespace {

using test::Bench;

constexpr double kCompanyTime = 2;  // [s]

Bench draggedWith(const std::vector<Actuator>& actuators) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  bench.world.solver.horizon = kCompanyTime;
  const MassProperties mass{2, Vector3d::Zero(), Vector3d(0.5, 0.7, 0.9).asDiagonal()};
  bench.add(makeBody("body", mass, actuators), test::tumbling({1, 0, 0}, {1, 1.5, 0.5}));
  bench.addMediumDrag(0, test::detail::everyDrag(test::Placement()), {-2, 3, 1});
  return bench;
}

Bench motorised() {
  Thruster jet;
  jet.position_B = {0.1, 0.05, -0.2};
  jet.direction_B = {0, 0.6, 0.8};
  jet.time_constant = 0.05;
  Wheel wheel;
  wheel.axis_B = {0, 0, 1};
  wheel.inertia = 0.05;
  wheel.speed = 100;
  Bench bench = draggedWith({Actuator{"jet", jet}, Actuator{"wheel", wheel}});
  bench.world.commands = {ActuatorCommand{0, 0, 25, 0.3}, ActuatorCommand{0, 1, 0.5, 1.234}};
  return bench;
}

Bench tethered() {
  Bench bench = draggedWith({});
  bench.world.laws.push_back(std::make_shared<Tether>(Spring::End{kWorld, {0, 0, 1}},
                                                      Spring::End{0, {0.1, 0, 0.2}},
                                                      Tether::Constants{300, 2, 1.5}));
  return bench;
}

Bench bouncing() {
  Bench bench = draggedWith({});
  bench.initial.bodies[0].x_W = {0, 0, 0.5};
  ContactShape ball;
  ball.balls = {{Vector3d::Zero(), 0.3}};
  ContactParameters parameters;
  parameters.stiffness = 1e5;
  parameters.dissipation = 0.5;
  parameters.friction = 0.4;
  bench.world.laws.push_back(
      contactWithHalfSpace(bench.world.bodies, 0, ball, HalfSpace{}, parameters));
  return bench;
}

/// Attitude, and place relative to some metres of path.
double companyGap(const State& a, const State& b) {
  return std::max(angleBetween(a.bodies[0].q_WP, b.bodies[0].q_WP),
                  (a.bodies[0].x_W - b.bodies[0].x_W).norm() / 2);
}

}  // namespace

TEST(MediumDrag, IsHeldToTheToleranceBesideMotorsTethersAndContact) {
  for (const auto& make : {motorised, tethered, bouncing}) {
    Bench bench = make();
    bench.world.solver.tolerance = 1e-12;
    const State truth = bench.run("dop853", kCompanyTime, 400);
    for (const double tolerance : {1e-4, 1e-8}) {
      bench.world.solver.tolerance = tolerance;
      bench.world.solver.tolerance_stated = true;
      Simulation sim = bench.simulation("auto", 0.1);
      while (sim.steps() < 20) sim.step();
      EXPECT_LE(companyGap(sim.state(), truth), tolerance) << describeSolution(sim)[0];
      EXPECT_GT(sim.evaluations(), 0);
    }
  }
}

// Their rates grow with speed, or not, law by law.
TEST(MediumDrag, WithoutAQuadraticPartIsSteppedBesideOtherLaws) {
  for (const auto& make : {motorised, bouncing}) {
    Bench bench = make();
    MediumDrag::Coefficients drag = test::detail::everyDrag(test::Placement());
    drag.quadratic = {};
    for (auto& law : bench.world.laws)
      if (law->name() == std::string("drag"))
        law = std::make_shared<MediumDrag>(0, drag, Vector3d(-2, 3, 1));
    bench.world.solver.tolerance = 1e-12;
    const State truth = bench.run("dop853", kCompanyTime, 400);
    EXPECT_LE(companyGap(bench.run("dop853", kCompanyTime, 200), truth), 1e-9);
  }
}

}  // namespace rigid_body_sim
