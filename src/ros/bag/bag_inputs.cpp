#include "ros/bag/bag_inputs.hpp"

#include <cmath>
#include <set>
#include <stdexcept>

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include "ros/inputs/input_messages.hpp"
#include "ros/inputs/static_frames.hpp"
#include "ros/inputs/wrench_intake.hpp"
#include "ros/inputs/wrench_messages.hpp"
#include "ros/node/node_options.hpp"
#include "scene/limits.hpp"

namespace rigid_body_sim {
namespace {

/// [s] No clock of a simulation that starts at zero comes this far; wall clocks passed it in 2001.
constexpr double kWallClock = 1e9;

std::vector<Input> recordedInputs(const rosbag::Bag& bag) {
  rosbag::View view(bag, rosbag::TypeQuery(ros::message_traits::datatype<Input>()));
  std::set<std::string> topics;
  std::vector<Input> inputs;
  for (const rosbag::MessageInstance& message : view) {
    topics.insert(message.getTopic());
    const Input::ConstPtr input = message.instantiate<Input>();
    if (!input) throw std::invalid_argument(message.getTopic() + " is of another version");
    inputs.push_back(*input);
  }
  if (topics.size() > 1)
    throw std::invalid_argument("must hold the inputs of one node, got " + *topics.begin() +
                                " and " + *topics.rbegin() + "; rosbag filter parts them");
  return inputs;
}

/// What the doors of a node would have made of the messages of a bag.
class Doors {
 public:
  Doors(const Scene& scene, const World& world)
      : world_(world),
        frames_(scene, world.bodies),
        rules_{scene.world_frame, NodeOptions().wrench_timeout} {}

  void take(const rosbag::Bag& bag) {
    rosbag::View view(bag);
    const ros::Time begin = view.size() > 0 ? view.getBeginTime() : ros::Time();
    if (begin.toSec() > kWallClock) origin_.start = begin;
    for (const rosbag::MessageInstance& message : view) take(message);
  }

  std::vector<Input> inputs;
  int refused = 0;

 private:
  void take(const rosbag::MessageInstance& message) {
    if (message.getTopic() == "/tf_static") {
      if (const auto frames = message.instantiate<tf2_msgs::TFMessage>())
        static_frames_.add(*frames);
    } else if (const AppliedWrench::ConstPtr wrench = message.instantiate<AppliedWrench>()) {
      take(toRequest(*wrench, origin_), message.getTime());
    } else if (const auto everyday = message.instantiate<geometry_msgs::WrenchStamped>()) {
      const std::string body = bodyOf(message.getTopic());
      if (!body.empty()) take(toRequest(body, *everyday), message.getTime());
    }
  }

  /// The body on whose everyday door a topic ends, /box/wrench or /robot/box/wrench; empty if none.
  std::string bodyOf(const std::string& topic) const {
    for (const Body& body : world_.bodies) {
      const std::string door = "/" + body.name + "/wrench";
      if (topic.size() >= door.size() &&
          topic.compare(topic.size() - door.size(), door.size(), door) == 0)
        return body.name;
    }
    return "";
  }

  void take(const WrenchRequest& request, const ros::Time& arrival) {
    const double h = world_.solver.time_step;
    const double step = std::ceil(origin_.simulationTime(arrival) / h - 1e-6);
    if (step > kMostSteps)
      throw std::invalid_argument("holds a message at more than 2^53 steps of the scene");
    static_frames_.lookUp(request.wrench.frame, frames_);
    static_frames_.lookUp(request.wrench.point_frame, frames_);
    const ResolvedWrench resolved = takeWrench(request, world_.bodies, frames_, rules_, step * h);
    if (!resolved.fault.empty()) {
      ++refused;
      return;
    }
    Input input = wrenchInput(request.slot, resolved.wrench, world_);
    input.number = inputs.size();
    input.step = static_cast<std::uint64_t>(step);
    input.time = step * h;
    inputs.push_back(input);
  }

  const World& world_;
  FrameTable frames_;
  StaticFrames static_frames_;
  IntakeRules rules_;
  TimeOrigin origin_;
};

BagInputs inputsOf(const rosbag::Bag& bag, const Scene& scene, const World& world) {
  const std::vector<Input> recorded = recordedInputs(bag);
  if (!recorded.empty()) return {recorded, ""};
  Doors doors(scene, world);
  doors.take(bag);
  if (doors.inputs.empty() && doors.refused == 0)
    throw std::invalid_argument("holds no wrench for a body of the scene");
  return {doors.inputs, "no ~inputs of a node: " + std::to_string(doors.inputs.size()) +
                            " wrenches taken at the times of the bag, " +
                            std::to_string(doors.refused) + " refused"};
}

}  // namespace

BagInputs readBagInputs(const std::string& path, const Scene& scene, const World& world) {
  try {
    rosbag::Bag bag;
    bag.open(path, rosbag::bagmode::Read);
    return inputsOf(bag, scene, world);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace rigid_body_sim
