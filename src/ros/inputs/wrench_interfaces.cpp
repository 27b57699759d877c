#include "ros/inputs/wrench_interfaces.hpp"

#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include "ros/messages/body_index.hpp"

namespace rigid_body_sim {
namespace {

constexpr std::uint32_t kStaticTfQueue = 100;

/// How many the scene schedules, body by body.
std::vector<std::size_t> wrenchesOfScene(const World& world) {
  std::vector<std::size_t> counts(world.bodies.size());
  for (const PointWrench& wrench : world.wrenches) ++counts[wrench.body];
  return counts;
}

}  // namespace

WrenchInterfaces::WrenchInterfaces(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh,
                                   const Scene& scene, const InputContext& context,
                                   const NodeOptions& options)
    : nh_(nh),
      context_(context),
      intake_(scene, context.simulation.world().bodies, options.wrench_timeout, options.tf_prefix),
      wrenches_of_scene_(wrenchesOfScene(context.simulation.world())) {
  for (const Body& body : context.simulation.world().bodies) {
    if (!body.fixed && options.body_topics) subscribe(body.name);
  }
  ros::NodeHandle own(private_nh);
  wrench_ = context_.subscribe<AppliedWrench>(
      own, "wrench", [this](const AppliedWrench& message) { take({message}, false); });
  wrenches_ = context_.subscribe<AppliedWrenches>(
      own, "wrenches", [this](const AppliedWrenches& message) { take(message.wrenches, true); });
  tf_static_ = nh_.subscribe("/tf_static", kStaticTfQueue, &WrenchIntake::addStatic, &intake_);
  apply_ = own.advertiseService("apply_wrench", &WrenchInterfaces::apply, this);
  apply_all_ = own.advertiseService("apply_wrenches", &WrenchInterfaces::applyAll, this);
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
  body_topics_[body] = context_.subscribe<BodyWrench>(
      nh_, body + "/wrench", [this, body](const BodyWrench& message) { take(body, message); });
}

bool WrenchInterfaces::apply(ApplyWrench::Request& request, ApplyWrench::Response& response) {
  response.message = take({request.wrench}, false);
  response.success = response.message.empty();
  return true;
}

bool WrenchInterfaces::applyAll(ApplyWrenches::Request& request,
                                ApplyWrenches::Response& response) {
  response.message = take(request.wrenches, true);
  response.success = response.message.empty();
  return true;
}

bool WrenchInterfaces::clear(ClearWrenches::Request& request, ClearWrenches::Response& response) {
  const Simulation& simulation = context_.simulation;
  const std::size_t before = simulation.wrenchCount();
  try {
    ClearInput input;
    if (!request.body.empty()) input.body = bodyNamed(request.body, simulation.world().bodies);
    input.slot = slotOfId(request.id);
    context_.inputs.apply(input);
    response.success = true;
    response.message = "ended: " + std::to_string(before - simulation.wrenchCount());
  } catch (const std::invalid_argument& refused) {
    response.message = refused.what();
  }
  return true;
}

/// Both return why the message is refused; empty if it is not.
std::string WrenchInterfaces::take(const std::string& body, const BodyWrench& message) {
  return context_.apply("wrench", [&](double now) {
    std::vector<WrenchInput> inputs{intake_.take(body, message, now)};
    requireRoom(inputs, false);
    return inputs;
  });
}

std::string WrenchInterfaces::take(const std::vector<AppliedWrench>& messages, bool is_list) {
  return context_.apply("wrench", [&](double now) {
    std::vector<WrenchInput> inputs =
        is_list ? intake_.take(messages, context_.origin, now)
                : std::vector<WrenchInput>{intake_.take(messages[0], context_.origin, now)};
    requireRoom(inputs, is_list);
    for (std::size_t k = 0; is_list && k < inputs.size(); ++k)
      withPlace(k, [&] { context_.simulation.checkWrenches({inputs[k]}); });
    context_.simulation.checkWrenches(inputs);
    return inputs;
  });
}

void WrenchInterfaces::requireRoom(const std::vector<WrenchInput>& inputs, bool is_list) const {
  const Simulation& simulation = context_.simulation;
  std::map<std::size_t, std::size_t> added;                // by body
  std::set<std::pair<std::size_t, std::string>> replaced;  // slots that the list itself fills
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const PointWrench& wrench = inputs[k].wrench;
    const std::string& slot = inputs[k].slot;
    if (simulation.replaces(slot, wrench)) continue;
    const bool acts_now = !slot.empty() && wrench.start <= simulation.time();
    if (acts_now && !replaced.emplace(wrench.body, slot).second) continue;
    if (simulation.wrenchCount(wrench.body) + added[wrench.body]++ <
        kMaxWrenches + wrenches_of_scene_[wrench.body])
      continue;
    throw std::invalid_argument((is_list ? "wrenches[" + std::to_string(k) + "]: " : "") +
                                "body '" + simulation.world().bodies[wrench.body].name +
                                "' must have fewer than " + std::to_string(kMaxWrenches) +
                                " wrenches that act or are to come");
  }
}

}  // namespace rigid_body_sim
