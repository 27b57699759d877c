// What IMUs cost beyond their messages: ten bodies with an IMU of 1 kHz each, noise and walk, the
// messages made and thrown away. CPU time of the outputs with subscribers less that without, as a
// share of a core at real time. Bound: 5 %.

#include <cstdio>
#include <ctime>
#include <string>
#include <utility>
#include <vector>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/outputs/outputs.hpp"

namespace rigid_body_sim {
namespace {

constexpr int kBodies = 10;
constexpr double kDuration = 1;  // [s] simulated

/// Topics that nobody reads, or that take messages and forget them.
struct Nobody {
  template <class Message>
  Topic<Message> open(const std::string& name, bool) {
    const bool is_imu =
        name.find("/imu") != std::string::npos && name.find("/truth") == std::string::npos;
    return {[this, is_imu] { return is_imu && listening ? 1U : 0U; },
            [](const Message&, const ros::Time&) {},
            [](const typename Topic<Message>::Greeting&) {}};
  }
  bool listening = false;
};

std::string sceneText(double time_step, const std::string& of_body, const std::string& more) {
  std::string text = "time_step: " + std::to_string(time_step) +
                     "\ngravity: [0, 0, -9.80665]\nbodies:\n  - {name: ground, shape: {plane: {}}, "
                     "fixed: true}\n";
  for (int i = 0; i < kBodies; ++i)
    text +=
        "  - {name: body" + std::to_string(i) +
        ", shape: {box: [0.3, 0.2, 0.1]}, mass: 1, position: [" + std::to_string(2 * i) +
        ", 0, 0.05], imus: {imu: {position: [0.1, 0, 0], rate: 1000, gyroscope: "
        "{noise_density: 1e-4, bias_walk: 1e-6}, accelerometer: {noise_density: 2e-3, bias_walk: "
        "3e-5}}}" +
        of_body + "}\n";
  return text + more;
}

double cpuTime() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// [s] of CPU time for the outputs of the whole run.
double timeOf(const Scene& scene, bool listening) {
  const World world = buildWorld(scene);
  Simulation simulation(world, initialState(scene, world));
  const TimeOrigin origin{ros::Time(1)};
  Nobody nobody{listening};
  Outputs outputs(openTopics(nobody, world, {}), NodeOptions(), scene, simulation, origin);
  double spent = 0;
  while (simulation.time() < kDuration) {
    const double start = cpuTime();
    outputs.publishDue();
    outputs.publishWithinStep(1e9);
    spent += cpuTime() - start;
    simulation.step();
  }
  return spent;
}

void measure(const char* what, double time_step, const std::string& of_body,
             const std::string& more = "") {
  const Scene scene = parseScene(sceneText(time_step, of_body, more), "benchmark");
  const double without = timeOf(scene, false), with = timeOf(scene, true);
  std::printf("%-44s %8.2f %% %10.2f\n", what, 100 * (with - without) / kDuration,
              1e6 * (with - without) / (kDuration * 1000 * kBodies));
}

}  // namespace
}  // namespace rigid_body_sim

int main() {
  using rigid_body_sim::measure;
  const std::string turns = ", twist: {frame: body, linear: [0, 0, 5], angular: [1, 2, 0.1]}";
  const std::string drag = turns + ", drag: {linear: 0.1, quadratic: 0.1, angular: 0.01}";
  const std::string rotor = turns +
                            ", rotors: {main: {position: [0.1, 0, 0], turns: ccw, thrust: 1e-5, "
                            "drag_torque: 1e-7, inertia: 6e-5, time_constant: 0.03, speed: 500}}";
  std::string contacts = "forces:\n", pushes = "wrenches:\n";
  for (int i = 0; i < rigid_body_sim::kBodies; ++i) {
    const std::string name = "body" + std::to_string(i);
    contacts += "  - {type: contact, between: [" + name +
                ", ground], stiffness: 1e5, dissipation: 0.4, friction: 0.5}\n";
    pushes += "  - {body: " + name + ", frame: " + name +
              ", point: [0.1, 0, 0], force: [0, 0, 5], duration: .inf}\n";
  }
  std::printf("%-44s %10s %10s\n", "10 IMUs of 1 kHz", "of a core", "us/sample");
  measure("falling, steps of 1 ms", 0.001, turns);
  measure("falling, steps of 10 ms", 0.01, turns);
  measure("pushed, steps of 1 ms", 0.001, turns, pushes);
  measure("pushed, steps of 10 ms", 0.01, turns, pushes);
  measure("rotors, steps of 1 ms", 0.001, rotor);
  measure("drag, steps of 1 ms", 0.001, drag);
  measure("drag, steps of 4 ms", 0.004, drag);
  measure("sliding on the ground, steps of 1 ms", 0.001,
          ", twist: {frame: world, linear: [3, 0, 0]}", contacts);
  measure("at rest on the ground, steps of 1 ms", 0.001, "", contacts);
  measure("bouncing, steps of 4 ms", 0.004, turns, contacts);
  return 0;
}
