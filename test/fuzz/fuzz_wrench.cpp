#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include <console_bridge/console.h>
#include <ros/serialization.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "dynamics/wrenches/wrench_schedule.hpp"
#include "fuzz/one_line.hpp"
#include "ros/inputs/wrench_intake.hpp"
#include "support/lopsided_box.hpp"

namespace rigid_body_sim {
namespace {

const std::string kScene = R"(
world_frame: map
time_step: 0.01
bodies:
)" + test::kLopsidedBox + R"(    position: [1, 2, 3]
    points: {tip: {position: [1, 0, 0], orientation: [0, 0, 0.6, 0.8]}}
  - {name: other, shape: {sphere: {radius: 1}}, mass: 1}
  - {name: post, shape: {sphere: {radius: 1}}, mass: 1, fixed: true}
)";

struct Target {
  Scene scene = parseScene(kScene, "fuzz.yaml");
  World world = buildWorld(scene);
  TimeOrigin origin{ros::Time(1700000000, 0)};
};

/// The message that a peer sent, as roscpp reads it; the stream throws where the bytes end early.
template <class Message>
Message received(ros::serialization::IStream& stream) {
  Message message;
  ros::serialization::deserialize(stream, message);
  return message;
}

/// Whether there can be as many transforms as the bytes claim. roscpp allocates for the claim, and
/// drops a message where that fails, before this package sees it.
bool holdsItsTransforms(const std::vector<std::uint8_t>& bytes) {
  std::uint32_t claimed = 0;
  if (bytes.size() >= sizeof claimed) std::memcpy(&claimed, bytes.data(), sizeof claimed);
  return claimed <= bytes.size();
}

bool isSound(const PointWrench& w, std::size_t bodies, double now) {
  const bool known = w.body < bodies && (w.axes == kWorld || w.axes < bodies) &&
                     (w.point_frame == kWorld || w.point_frame < bodies);
  return known && w.start >= now && w.end > w.start && w.force.allFinite() &&
         w.torque.allFinite() && w.point.allFinite();
}

constexpr double kNow = 4;

/// resolve(): the input that the intake makes of a message.
template <class Resolve>
void take(std::size_t bodies, const Resolve& resolve) {
  WrenchInput input;
  try {
    input = resolve();
  } catch (const std::invalid_argument& refused) {
    requireOneLine(refused.what(), 1000);
    return;
  }
  if (!isSound(input.wrench, bodies, kNow)) std::abort();
  WrenchSchedule schedule;
  schedule.put(input.slot, input.wrench, kNow);
  schedule.advanceTo(input.wrench.start);
  if (schedule.active().size() != 1) std::abort();
}

}  // namespace
}  // namespace rigid_body_sim

/// tf2 prints every transform that it refuses: gigabytes in half an hour.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  console_bridge::noOutputHandler();
  return 0;
}

/// Any bytes that arrive as messages, after a first byte that says of which kind, become a wrench
/// that the core can take or are refused in one line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rigid_body_sim;
  static const Target target;
  if (size < 2) return -1;
  std::vector<std::uint8_t> bytes(data + 1, data + size);
  const bool has_transforms = data[0] & 2;
  if (has_transforms && !holdsItsTransforms(bytes)) return -1;
  ros::serialization::IStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  try {
    WrenchIntake intake(target.scene, target.world.bodies, 0.5);
    if (has_transforms) intake.addStatic(received<tf2_msgs::TFMessage>(stream));
    const std::size_t bodies = target.world.bodies.size();
    if (data[0] & 1) {
      const auto message = received<geometry_msgs::WrenchStamped>(stream);
      take(bodies, [&] { return intake.take("box", message, kNow); });
    } else {
      const auto message = received<AppliedWrench>(stream);
      take(bodies, [&] { return intake.take(message, target.origin, kNow); });
    }
  } catch (const ros::serialization::StreamOverrunException&) {
    return -1;  // not a message: not worth keeping
  }
  return 0;
}
