#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

#include <fuzzer/FuzzedDataProvider.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "fuzz/one_line.hpp"
#include "ros/inputs/command_intake.hpp"

namespace rigid_body_sim {
namespace {

const char* const kScene = R"(
time_step: 0.01
bodies:
  - name: ship
    shape: {sphere: {radius: 1}}
    mass: 1
    thrusters: {main: {}, m: {limits: [-1, 1]}}
    rotors: {left: {turns: cw, thrust: 1.0e-5, limits: [0, 100]}}
    wheels: {yaw: {axis: [0, 0, 1], inertia: 0.01}}
)";

constexpr double kNow = 4;

/// Any bits, special numbers included.
std::vector<double> anyNumbers(FuzzedDataProvider& data) {
  std::vector<double> numbers(data.ConsumeIntegralInRange<std::size_t>(0, 5));
  for (double& number : numbers) number = data.ConsumeFloatingPoint<double>();
  if (!numbers.empty() && data.ConsumeBool()) numbers[0] = std::nan("");
  return numbers;
}

sensor_msgs::JointState anyMessage(FuzzedDataProvider& data) {
  const std::string known[] = {"main", "m", "left", "yaw"};
  sensor_msgs::JointState message;
  message.header.stamp.sec = data.ConsumeIntegral<std::uint32_t>();
  message.header.stamp.nsec = data.ConsumeIntegral<std::uint32_t>();
  message.name.resize(data.ConsumeIntegralInRange<std::size_t>(0, 5));
  for (std::string& name : message.name)
    name = data.ConsumeBool() ? data.PickValueInArray(known) : data.ConsumeRandomLengthString(300);
  message.velocity = anyNumbers(data);
  message.effort = anyNumbers(data);
  if (data.ConsumeBool()) message.position = anyNumbers(data);
  return message;
}

bool isSound(const ActuatorCommand& command, const World& world) {
  return command.body == 0 && command.actuator < world.bodies[0].actuators.size() &&
         std::isfinite(command.value) && std::isfinite(command.start) && command.start >= kNow &&
         command.end > command.start;
}

}  // namespace
}  // namespace rigid_body_sim

/// Any message becomes commands that the core can take, one for each name, or is refused in one
/// line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace rigid_body_sim;
  static const World world = buildWorld(parseScene(kScene, "fuzz.yaml"));
  FuzzedDataProvider data(bytes, size);
  const sensor_msgs::JointState message = anyMessage(data);
  try {
    const std::vector<CommandInput> inputs =
        CommandIntake(world, 0.5).take(0, message, TimeOrigin{ros::Time(1700000000, 0)}, kNow);
    if (inputs.size() != message.name.size()) std::abort();
    for (const CommandInput& input : inputs)
      if (!isSound(input.command, world)) std::abort();
  } catch (const std::invalid_argument& refused) {
    requireOneLine(refused.what(), 1000);
  }
  return 0;
}
