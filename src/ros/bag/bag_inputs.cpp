#include "ros/bag/bag_inputs.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include <rosbag/bag.h>
#include <rosbag/view.h>

#include "ros/bag/node_of_topics.hpp"
#include "ros/bag/open_bag.hpp"
#include "ros/inputs/command_intake.hpp"
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
                                " and " + *topics.rbegin() + "; rosbag filter separates them");
  return inputs;
}

/// What the interfaces of a node for wrenches and commands would have made of the messages of a
/// bag.
class InputMessages {
 public:
  InputMessages(const Scene& scene, const World& world)
      : world_(world),
        intake_(scene, world.bodies, NodeOptions().wrench_timeout),
        commands_(world, NodeOptions().command_timeout) {}

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
      node_.addOwnTopic(message.getTopic(), "wrench");
      add(message.getTime(), [&](double now) { return one(intake_.take(*wrench, origin, now)); });
    } else if (const AppliedWrenches::ConstPtr list = message.instantiate<AppliedWrenches>()) {
      node_.addOwnTopic(message.getTopic(), "wrenches");
      add(message.getTime(), [&](double now) {
        const std::vector<WrenchInput> wrenches = intake_.take(list->wrenches, origin, now);
        return Inputs(wrenches.begin(), wrenches.end());
      });
    } else if (const auto on_body = message.instantiate<geometry_msgs::WrenchStamped>()) {
      const auto body = bodyOf(message.getTopic(), "/wrench");
      if (!body) return;
      const std::string& name = world_.bodies[*body].name;
      node_.addTopicOfBody(message.getTopic(), name + "/wrench");
      add(message.getTime(), [&](double now) { return one(intake_.take(name, *on_body, now)); });
    } else if (const auto command = message.instantiate<sensor_msgs::JointState>()) {
      const auto body = bodyOf(message.getTopic(), "/command");
      if (!body || world_.bodies[*body].actuators.empty()) return;
      node_.addTopicOfBody(message.getTopic(), world_.bodies[*body].name + "/command");
      add(message.getTime(), [&](double now) { return take(*body, *command, now); });
    }
  }

  using Inputs = std::vector<SimulationInput>;

  static Inputs one(SimulationInput input) { return {std::move(input)}; }

  Inputs take(std::size_t body, const sensor_msgs::JointState& message, double now) const {
    const std::vector<CommandInput> commands = commands_.take(body, message, origin, now);
    return {commands.begin(), commands.end()};
  }

  /// The body whose topic this is, /box/wrench or /robot/box/wrench; none where it is no body's.
  std::optional<std::size_t> bodyOf(const std::string& topic, const std::string& kind) const {
    for (std::size_t i = 0; i < world_.bodies.size(); ++i) {
      const std::string ending = "/" + world_.bodies[i].name + kind;
      if (topic.size() >= ending.size() &&
          topic.compare(topic.size() - ending.size(), ending.size(), ending) == 0)
        return i;
    }
    return std::nullopt;
  }

  /// resolve(now): the inputs of a message that arrives at the step boundary `now` [s].
  template <class Resolve>
  void add(const ros::Time& arrival, const Resolve& resolve) {
    const double h = world_.solver.time_step;
    const double step = std::ceil(origin.simulationTime(arrival) / h - 1e-6);
    if (step > kMaxSteps)
      throw std::invalid_argument("holds a message at more than 2^53 steps of the scene");
    try {
      for (SimulationInput& input : resolve(step * h))
        inputs.push_back({static_cast<std::uint64_t>(step), std::move(input)});
    } catch (const std::invalid_argument&) {
      ++refused;
    }
  }

  const World& world_;
  WrenchIntake intake_;
  CommandIntake commands_;
  NodeOfTopics node_;
};

BagInputs inputsOf(const rosbag::Bag& bag, const Scene& scene, const World& world) {
  const std::vector<Input> recorded = recordedInputs(bag);
  if (!recorded.empty()) {
    BagInputs result{lastRun(recorded, world, scene.world_frame), {}, ""};
    const Input& last = recorded.back();
    result.is_of_later_run = std::any_of(recorded.begin(), recorded.end(),
                                         [](const Input& input) { return input.run > 0; });
    const std::int64_t start =
        static_cast<std::int64_t>(last.header.stamp.toNSec()) - std::llround(last.time * 1e9);
    result.origin.start.fromNSec(static_cast<std::uint64_t>(std::max<std::int64_t>(start, 0)));
    return result;
  }
  InputMessages messages(scene, world);
  messages.take(bag);
  if (messages.inputs.empty() && messages.refused == 0)
    throw std::invalid_argument("holds no wrench and no command for a body of the scene");
  return {messages.inputs, messages.origin,
          "no ~inputs of a node: " + std::to_string(messages.inputs.size()) +
              " inputs taken at the times of the bag, " + std::to_string(messages.refused) +
              " refused"};
}

}  // namespace

BagInputs readBagInputs(const std::string& path, const Scene& scene, const World& world) {
  try {
    rosbag::Bag bag;
    openBag(path, bag);
    return inputsOf(bag, scene, world);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace rigid_body_sim
