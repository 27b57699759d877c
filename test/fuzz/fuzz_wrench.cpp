#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include <console_bridge/console.h>
#include <ros/serialization.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "dynamics/wrenches/wrench_schedule.hpp"
#include "ros/inputs/static_frames.hpp"
#include "ros/inputs/wrench_intake.hpp"
#include "ros/inputs/wrench_messages.hpp"
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
  FrameTable frames{scene, world.bodies};
  IntakeRules rules{"map", 0.5};
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

void take(const WrenchRequest& request, const StaticFrames& static_frames, const Target& target) {
  constexpr double kNow = 4;
  FrameTable frames = target.frames;
  static_frames.lookUp(request.wrench.frame, frames);
  static_frames.lookUp(request.wrench.point_frame, frames);
  const ResolvedWrench taken = takeWrench(request, target.world.bodies, frames, target.rules, kNow);
  if (!taken.fault.empty()) {
    if (taken.fault.find_first_of("\n\r") != std::string::npos || taken.fault.size() > 1000)
      std::abort();
    return;
  }
  if (!isSound(taken.wrench, target.world.bodies.size(), kNow)) std::abort();
  WrenchSchedule schedule;
  schedule.put(request.slot, taken.wrench, kNow);
  schedule.advanceTo(taken.wrench.start);
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
    StaticFrames static_frames;
    if (has_transforms) static_frames.add(received<tf2_msgs::TFMessage>(stream));
    if (data[0] & 1)
      take(toRequest("box", received<geometry_msgs::WrenchStamped>(stream)), static_frames, target);
    else
      take(toRequest(received<AppliedWrench>(stream), target.origin), static_frames, target);
  } catch (const ros::serialization::StreamOverrunException&) {
    return -1;  // not a message: not worth keeping
  }
  return 0;
}
