#include "ros/bag/bag_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include "ros/inputs/wrench_intake.hpp"
#include "ros/options/node_options.hpp"
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

/// What the wrench interfaces of a node would have made of the messages of a bag.
class WrenchMessages {
 public:
  WrenchMessages(const Scene& scene, const World& world)
      : world_(world), intake_(scene, world.bodies, NodeOptions().wrench_timeout) {}

  void take(const rosbag::Bag& bag) {
    rosbag::View view(bag);
    const ros::Time begin = view.size() > 0 ? view.getBeginTime() : ros::Time();
    if (begin.toSec() > kWallClock) origin.start = begin;
    for (const rosbag::MessageInstance& message : view) take(message);
  }

  std::vector<TimedInput> inputs;
  TimeOrigin origin;
  int refused = 0;

 private:
  void take(const rosbag::MessageInstance& message) {
    if (message.getTopic() == "/tf_static") {
      if (const auto frames = message.instantiate<tf2_msgs::TFMessage>())
        intake_.addStatic(*frames);
    } else if (const AppliedWrench::ConstPtr wrench = message.instantiate<AppliedWrench>()) {
      requireOneTopic("", message.getTopic());
      add(message.getTime(), [&](double now) { return intake_.take(*wrench, origin, now); });
    } else if (const auto on_body = message.instantiate<geometry_msgs::WrenchStamped>()) {
      const std::string body = bodyOf(message.getTopic());
      if (body.empty()) return;
      requireOneTopic(body, message.getTopic());
      add(message.getTime(), [&](double now) { return intake_.take(body, *on_body, now); });
    }
  }

  /// The body whose topic this is, /box/wrench or /robot/box/wrench; empty if none.
  std::string bodyOf(const std::string& topic) const {
    for (const Body& body : world_.bodies) {
      const std::string ending = "/" + body.name + "/wrench";
      if (topic.size() >= ending.size() &&
          topic.compare(topic.size() - ending.size(), ending.size(), ending) == 0)
        return body.name;
    }
    return "";
  }

  /// Two topics of one kind are those of two nodes, of which the scene is one. The topic for any
  /// body has the body "".
  void requireOneTopic(const std::string& body, const std::string& topic) {
    const std::string& known = topics_.emplace(body, topic).first->second;
    if (known != topic)
      throw std::invalid_argument("must hold the wrenches of one node, got " + known + " and " +
                                  topic + "; rosbag filter parts them");
  }

  /// resolve(now): the input of a message that arrives at the step boundary `now` [s].
  template <class Resolve>
  void add(const ros::Time& arrival, const Resolve& resolve) {
    const double h = world_.solver.time_step;
    const double step = std::ceil(origin.simulationTime(arrival) / h - 1e-6);
    if (step > kMaxSteps)
      throw std::invalid_argument("holds a message at more than 2^53 steps of the scene");
    try {
      inputs.push_back({static_cast<std::uint64_t>(step), resolve(step * h)});
    } catch (const std::invalid_argument&) {
      ++refused;
    }
  }

  const World& world_;
  WrenchIntake intake_;
  std::map<std::string, std::string> topics_;  // by body
};

BagInputs inputsOf(const rosbag::Bag& bag, const Scene& scene, const World& world) {
  const std::vector<Input> recorded = recordedInputs(bag);
  if (!recorded.empty()) {
    BagInputs result{lastRun(recorded, world, scene.world_frame), {}, ""};
    const Input& last = recorded.back();
    const std::int64_t start =
        static_cast<std::int64_t>(last.header.stamp.toNSec()) - std::llround(last.time * 1e9);
    result.origin.start.fromNSec(static_cast<std::uint64_t>(std::max<std::int64_t>(start, 0)));
    return result;
  }
  WrenchMessages messages(scene, world);
  messages.take(bag);
  if (messages.inputs.empty() && messages.refused == 0)
    throw std::invalid_argument("holds no wrench for a body of the scene");
  return {messages.inputs, messages.origin,
          "no ~inputs of a node: " + std::to_string(messages.inputs.size()) +
              " wrenches taken at the times of the bag, " + std::to_string(messages.refused) +
              " refused"};
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
