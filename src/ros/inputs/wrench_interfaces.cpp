#include "ros/inputs/wrench_interfaces.hpp"

#include <stdexcept>

#include "ros/messages/body_index.hpp"

namespace rigid_body_sim {
namespace {

/// Messages that may wait for the next step boundary: a tenth of a second at 10 000 a second.
constexpr std::uint32_t kWrenchQueue = 1000;
constexpr std::uint32_t kStaticTfQueue = 100;

template <class Message>
using Callback = boost::function<void(const boost::shared_ptr<const Message>&)>;

template <class Message>
ros::Subscriber subscribeAtOnce(ros::NodeHandle nh, const std::string& topic,
                                const Callback<Message>& callback) {
  return nh.subscribe<Message>(topic, kWrenchQueue, callback, ros::VoidConstPtr(),
                               ros::TransportHints().tcpNoDelay());
}

/// How many the scene schedules, body by body.
std::vector<std::size_t> wrenchesOfScene(const World& world) {
  std::vector<std::size_t> counts(world.bodies.size());
  for (const PointWrench& wrench : world.wrenches) ++counts[wrench.body];
  return counts;
}

}  // namespace

WrenchInterfaces::WrenchInterfaces(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh,
                                   const Scene& scene, const Simulation& simulation, Inputs& inputs,
                                   const TimeOrigin& origin, const NodeOptions& options,
                                   Refusals& refusals)
    : nh_(nh),
      simulation_(simulation),
      inputs_(inputs),
      origin_(origin),
      refusals_(refusals),
      intake_(scene, simulation.world().bodies, options.wrench_timeout, options.tf_prefix),
      wrenches_of_scene_(wrenchesOfScene(simulation.world())) {
  for (const Body& body : simulation.world().bodies) {
    if (!body.fixed && options.body_topics) subscribe(body.name);
  }
  ros::NodeHandle own(private_nh);
  wrench_ = subscribeAtOnce<AppliedWrench>(
      own, "wrench", [this](const AppliedWrench::ConstPtr& message) { take(*message, origin_); });
  tf_static_ = nh_.subscribe("/tf_static", kStaticTfQueue, &WrenchIntake::addStatic, &intake_);
  apply_ = own.advertiseService("apply_wrench", &WrenchInterfaces::apply, this);
  clear_ = own.advertiseService("clear_wrenches", &WrenchInterfaces::clear, this);
}

void WrenchInterfaces::add(const BodyDef& def, std::size_t body) {
  intake_.add(def, body);
  if (!def.fixed) subscribe(def.name);
}

void WrenchInterfaces::remove(const std::string& body) {
  body_topics_.erase(body);
  intake_.remove(body);
}

void WrenchInterfaces::subscribe(const std::string& body) {
  body_topics_[body] = subscribeAtOnce<BodyWrench>(
      nh_, body + "/wrench",
      [this, body](const BodyWrench::ConstPtr& message) { take(body, *message); });
}

bool WrenchInterfaces::apply(ApplyWrench::Request& request, ApplyWrench::Response& response) {
  response.message = take(request.wrench, origin_);
  response.success = response.message.empty();
  return true;
}

bool WrenchInterfaces::clear(ClearWrenches::Request& request, ClearWrenches::Response& response) {
  const std::size_t before = simulation_.wrenchCount();
  try {
    ClearInput input;
    if (!request.body.empty()) input.body = bodyNamed(request.body, simulation_.world().bodies);
    input.slot = slotOfId(request.id);
    inputs_.apply(input);
    response.success = true;
    response.message = "ended: " + std::to_string(before - simulation_.wrenchCount());
  } catch (const std::invalid_argument& refused) {
    response.message = refused.what();
  }
  return true;
}

/// Applies what the intake makes of a message. Returns why it is refused; empty if it is not.
template <class... Message>
std::string WrenchInterfaces::take(const Message&... message) {
  try {
    const WrenchInput input = intake_.take(message..., simulation_.time());
    requireRoom(input);
    inputs_.apply(input);
    return "";
  } catch (const std::invalid_argument& refused) {
    refusals_.add("wrench", refused.what());
    return refused.what();
  }
}

void WrenchInterfaces::requireRoom(const WrenchInput& input) const {
  const std::size_t body = input.wrench.body;
  if (simulation_.wrenchCount(body) < kMaxWrenches + wrenches_of_scene_[body] ||
      simulation_.replaces(input.slot, input.wrench))
    return;
  throw std::invalid_argument("body '" + simulation_.world().bodies[body].name +
                              "' must have less than " + std::to_string(kMaxWrenches) +
                              " wrenches that act or are to come");
}

}  // namespace rigid_body_sim
