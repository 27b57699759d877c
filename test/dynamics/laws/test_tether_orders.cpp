#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "dynamics/methods/catalogue.hpp"
#include "support/tether_drop.hpp"

/// A step ends where a tether becomes taut or slack, so that every integrator keeps its order.
namespace rigid_body_sim {
namespace {

/// Errors of a fall into the tether and out of it, in 120 and in 240 steps.
std::vector<double> dropErrors(const Method& method, double damping) {
  const double expected = test::TetherDrop(damping).z(0.6);
  std::vector<double> errors;
  for (int steps : {120, 240})
    errors.push_back(std::abs(
        test::droppedBall(damping).run(method.name, 0.6, steps).bodies[0].x_W.z() - expected));
  return errors;
}

/// Returns the number of integrators that support it.
int expectOrders(double damping) {
  int supporting = 0;
  const test::Bench bench = test::droppedBall(damping);
  for (const Method& method : catalogue()) {
    if (!method.supports(bench.world.laws[0]->needs())) {
      EXPECT_THROW(bench.simulation(method.name, 0.01), std::invalid_argument);
      continue;
    }
    ++supporting;
    const std::vector<double> errors = dropErrors(method, damping);
    EXPECT_LT(errors[0], std::pow(15 * 0.005, method.order) + 1e-13) << method.name;
    if (errors[1] > 1e-13) {
      EXPECT_GT(errors[0] / errors[1], std::exp2(method.order) / 1.6) << method.name;
    }
  }
  return supporting;
}

}  // namespace

TEST(Tether, ConvergesAtTheOrderOfEveryIntegratorThatSupportsItsDamping) {
  EXPECT_EQ(expectOrders(3), 3);
}

TEST(Tether, ConvergesAtTheOrderOfEveryIntegratorThatSupportsItUndamped) {
  EXPECT_EQ(expectOrders(0), 7);
}

}  // namespace rigid_body_sim
