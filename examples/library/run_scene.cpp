// Simulates a scene file for a second and prints where its bodies are then.
// usage: run_scene SCENE
#include <cstdio>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

namespace rbs = rigid_body_sim;

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: run_scene SCENE\n", stderr);
    return 2;
  }
  try {
    // files of other ROS packages: loadScene(path, ros::package::getPath)
    const rbs::Scene scene = rbs::loadScene(argv[1]);
    const rbs::World world = rbs::buildWorld(scene);
    rbs::Simulation simulation(world, rbs::initialState(scene, world));
    while (simulation.time() < 1) simulation.step();
    for (std::size_t i = 0; i < world.bodies.size(); ++i) {
      const rbs::BodyFrameMotion m = rbs::toBodyFrameMotion(world.bodies[i], simulation.body(i));
      std::printf("%s,%.17g,%.17g,%.17g\n", world.bodies[i].name.c_str(), m.x_W.x(), m.x_W.y(),
                  m.x_W.z());
    }
  } catch (const rbs::SceneError& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  } catch (const rbs::SimulationDiverged& diverged) {
    std::fprintf(stderr, "run_scene: %s\n", diverged.what());
    return 3;
  }
  return 0;
}
