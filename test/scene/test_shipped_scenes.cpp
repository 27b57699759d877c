#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

namespace rigid_body_sim {

TEST(EveryShippedScene, LoadsStepsAndSaysWhatItShows) {
  int count = 0;
  for (const auto& file : std::filesystem::directory_iterator(RIGID_BODY_SIM_SCENES)) {
    if (file.path().extension() != ".yaml") continue;
    SCOPED_TRACE(file.path().string());
    ++count;
    Scene scene;
    ASSERT_NO_THROW(scene = loadScene(file.path().string()));
    ASSERT_NO_THROW({
      const World world = buildWorld(scene);
      Simulation simulation(world, initialState(scene, world));
      simulation.step();
    });

    std::string first_line;
    std::getline(std::ifstream(file.path()), first_line);
    EXPECT_EQ(first_line.substr(0, 2), "# ");
    EXPECT_GT(first_line.size(), 20U);
  }
  EXPECT_GE(count, 4);
}

}  // namespace rigid_body_sim
