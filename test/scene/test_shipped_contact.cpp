#include <cmath>
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/contact_point.hpp>
#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

namespace rigid_body_sim {
namespace {

/// [s] The first second of few bodies, less of many; all with RIGID_BODY_SIM_LONG_TESTS.
double spanOf(const World& world) {
  if (std::getenv("RIGID_BODY_SIM_LONG_TESTS")) return world.solver.horizon;
  return world.bodies.size() > 20 ? 0.5 : 1;
}

void expectNoEnergyFromNowhere(World world, const State& initial) {
  world.solver.tolerance = 1e-9;  // whatever the scene makes do with
  world.solver.tolerance_stated = false;
  const double span = spanOf(world);
  Simulation simulation(world, initial);
  double last = mechanicalEnergy(world, initial);
  const double rounding = 1e-11 * std::abs(last);
  std::size_t touches = 0;
  while (simulation.time() < span) {
    simulation.step();
    touches += simulation.contactEvents().size();
    const double now = mechanicalEnergy(world, simulation.state());
    ASSERT_LT(now - last, rounding) << simulation.time();
    last = now;
  }
  EXPECT_GT(touches + contactsOf(world, simulation.state()).size(), 0U);
}

TEST(ShippedContact, GainsNoEnergyWhereNothingDrivesIt) {
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator(RIGID_BODY_SIM_SCENES)) {
    if (file.path().extension() != ".yaml") continue;
    SCOPED_TRACE(file.path().string());
    const Scene scene = loadScene(file.path().string());
    const World world = buildWorld(scene);
    const bool driven = !world.wrenches.empty() || !world.commands.empty();
    if (driven || !hasContact(world)) continue;
    ++count;
    expectNoEnergyFromNowhere(world, initialState(scene, world));
  }
  EXPECT_GE(count, 8);
}

}  // namespace
}  // namespace rigid_body_sim
