#include "ros/outputs/outputs.hpp"

#include <algorithm>
#include <utility>

#include <rigid_body_sim/dynamics/contact_point.hpp>

#include "math/instant_rounding.hpp"
#include "ros/outputs/law_forces.hpp"
#include "ros/outputs/markers.hpp"
#include "ros/outputs/state_messages.hpp"

namespace rigid_body_sim {
namespace {

/// Arrows and trails are for the eye [1/s of simulation time].
constexpr double kMarkerRate = 30;

}  // namespace

Outputs::Outputs(OutputTopics topics, const NodeOptions& options, const Scene& scene,
                 const Simulation& simulation, const TimeOrigin& origin)
    : topics_(std::move(topics)),
      simulation_(&simulation),
      within_(options.publish_rate),
      origin_(origin),
      messages_(scene, options),
      publish_clock_(options.publish_clock),
      state_instants_(options.publish_rate, simulation.time()),
      clock_instants_(options.clock_rate, simulation.time()),
      marker_instants_(std::min(options.publish_rate, kMarkerRate), simulation.time()),
      contacts_(topics_.contacts, scene.world_frame, origin),
      imus_(origin),
      live_markers_(topics_.live_markers, scene.world_frame, messages_.frames().bodies()),
      markers_(topics_.markers, toMarkers(scene, messages_.frames())),
      absent_(simulation.world().bodies.size()) {
  std::vector<std::optional<BodyTopics>> of_body(simulation.world().bodies.size());
  for (BodyTopics& own : std::exchange(topics_.bodies, {})) of_body[own.body] = std::move(own);
  for (std::size_t i = 0; i < of_body.size(); ++i) take(i, std::move(of_body[i]));
  listBodies();
  publishOnce();
  greet();
}

void Outputs::publishOnce() {
  const ros::Time stamp = origin_.stamp(simulation_->time());
  const tf2_msgs::TFMessage frames = messages_.fixedTransforms(*simulation_, stamp);
  if (!frames.transforms.empty()) topics_.tf_static.publish(frames, stamp);
  markers_.publish(absentBodies(), stamp);
}

/// What is sent to a subscriber that comes while time stands: to it alone, so that every subscriber
/// receives strictly increasing stamps on /tf.
template <class ToMessage>
auto Outputs::greeting(ToMessage toMessage, std::optional<std::size_t> body) {
  return [this, toMessage, body]() {
    using Message = decltype(toMessage(shown(), ros::Time()));
    if (!standing_ || (body && isAbsent(*body))) return std::optional<Message>();
    const Snapshot snapshot = shown();
    return std::optional<Message>(toMessage(snapshot, origin_.stamp(snapshot.time())));
  };
}

void Outputs::greet() {
  topics_.tf.greetWith(greeting([this](const Snapshot& snapshot, const ros::Time& stamp) {
    greeted_ = stamp;
    return messages_.transforms(moving_, snapshot, stamp);
  }));
  topics_.states.greetWith(greeting([this](const Snapshot& snapshot, const ros::Time& stamp) {
    setStates(snapshot, stamp);
    return states_;
  }));
  contacts_.greetWith(greeting([this](const Snapshot& snapshot, const ros::Time& stamp) {
    return contacts_.standing(snapshot, stamp);
  }));
  if (!topics_.law_forces.greetWith) return;
  topics_.law_forces.greetWith(greeting([this](const Snapshot& snapshot, const ros::Time& stamp) {
    return toLawForces(snapshot, messages_.worldFrame(), stamp);
  }));
}

void Outputs::greet(const BodyTopics& topics) {
  const std::size_t body = topics.body;
  const auto greetWith = [&](const auto& topic, const auto& toMessage) {
    if (topic.greetWith) topic.greetWith(greeting(toMessage, body));
  };
  greetWith(topics.odometry, [=](const Snapshot& snapshot, const ros::Time& stamp) {
    return messages_.odometry(body, snapshot, stamp);
  });
  greetWith(topics.acceleration, [=](const Snapshot& snapshot, const ros::Time& stamp) {
    return messages_.acceleration(body, snapshot, snapshot.motions({body})[0], stamp);
  });
  greetWith(topics.applied_wrench, [=](const Snapshot& snapshot, const ros::Time& stamp) {
    return messages_.appliedWrench(body, snapshot, stamp);
  });
  greetWith(topics.pivot_force, [=](const Snapshot& snapshot, const ros::Time& stamp) {
    return messages_.pivotForce(body, snapshot, snapshot.motions({body})[0], stamp);
  });
  greetWith(topics.actuators, [=](const Snapshot& snapshot, const ros::Time& stamp) {
    return messages_.actuators(body, snapshot, stamp);
  });
}

double Outputs::shownTime() const { return std::max(last_t_, simulation_->time()); }

double Outputs::nextOfAll() const {
  const double t = std::min(state_instants_.next(), imus_.next());
  return publish_clock_ ? std::min(t, clock_instants_.next()) : t;
}

/// Touches and releases are those of single steps.
double Outputs::nextInstant() const {
  const bool has_changes = contacts_.hasSubscribers() && hasContact(simulation_->world());
  return has_changes ? simulation_->time() : nextOfAll();
}

std::optional<double> Outputs::instantWithinStep() const {
  const double h = simulation_->world().solver.time_step;
  const double t_end = static_cast<double>(simulation_->steps() + 1) * h;
  const double t = nextOfAll();
  if (t < t_end - instantRounding(t_end, h)) return t;
  return std::nullopt;
}

void Outputs::publishInstant(double t) { publishAt(t, t); }

void Outputs::publishWithinStep(double t_end) {
  const double rounding = instantRounding(t_end, simulation_->world().solver.time_step);
  const double reach = t_end + rounding;
  // where nobody looks they are none of a long step's work; those of its end are due after it
  if (!isWatched())
    for (Instants* instants : {&state_instants_, &marker_instants_})
      instants->passTo(t_end - rounding);
  for (auto t = instantWithinStep(); t && *t <= reach; t = instantWithinStep()) publishInstant(*t);
}

void Outputs::publishDue() {
  const double t = simulation_->time();
  contacts_.keepChanges(*simulation_);
  publishAt(t, t + instantRounding(t, simulation_->world().solver.time_step));
}

/// Publishes at time t [s] what is due at instants up to `reach`.
void Outputs::publishAt(double t, double reach) {
  if (publish_clock_ && clock_instants_.next() <= reach) {
    clock_instants_.passTo(reach);
    publishClock(t);
  }
  if (imus_.publishDue(*simulation_, t, reach)) last_t_ = t;
  if (state_instants_.next() <= reach) {
    state_instants_.passTo(reach);
    const bool with_markers = marker_instants_.next() <= reach;
    marker_instants_.passTo(reach);
    publishState(t, with_markers);
  }
}

void Outputs::publishNow() {
  if (publish_clock_) publishClock(simulation_->time());
  publishState(simulation_->time(), true);
}

void Outputs::repeatClock() {
  if (!publish_clock_) return;
  rosgraph_msgs::Clock message;
  message.clock = origin_.stamp(shownTime());
  topics_.clock.publish(message, message.clock);
}

void Outputs::repeatState() {
  if (!asksForState()) return;
  const Snapshot snapshot = shown();
  publishBodyTopics(snapshot, origin_.stamp(snapshot.time()));
}

void Outputs::repeatBodies() { markers_.repeat(origin_.stamp(simulation_->time())); }

ros::Time Outputs::lastStamp() const {
  if (!last_state_stamp_ && !last_clock_stamp_) return origin_.stamp(simulation_->time());
  return std::max(last_state_stamp_.value_or(ros::Time()), last_clock_stamp_.value_or(ros::Time()));
}

void Outputs::restart(double t) {
  takeInput();
  last_state_stamp_ = last_clock_stamp_ = greeted_ = std::nullopt;
  contacts_.restart();
  imus_.restart(t);
  last_t_ = 0;
  for (Instants* instants : {&state_instants_, &clock_instants_, &marker_instants_})
    instants->restart(t);
}

void Outputs::publishClock(double t) {
  rosgraph_msgs::Clock message;
  message.clock = origin_.stamp(t);
  if (message.clock <= last_clock_stamp_) return;
  last_clock_stamp_ = message.clock;
  last_t_ = t;
  topics_.clock.publish(message, message.clock);
}

void Outputs::publishState(double t, bool with_markers) {
  const ros::Time stamp = origin_.stamp(t);
  if (stamp <= last_state_stamp_) return;
  last_state_stamp_ = stamp;
  last_t_ = t;
  const bool seen = live_markers_.hasSubscribers();
  if (!seen) live_markers_.forget();
  if (!asksForState() && !topics_.tf.subscribers() && !(seen && with_markers)) return;
  const Snapshot snapshot(*simulation_, within_, t);
  if (topics_.tf.subscribers() && stamp != greeted_) {
    const tf2_msgs::TFMessage frames = messages_.transforms(moving_, snapshot, stamp);
    if (!frames.transforms.empty()) topics_.tf.publish(frames, stamp);
  }
  publishBodyTopics(snapshot, stamp);
  if (seen && with_markers) live_markers_.publish(snapshot, stamp);
}

bool Outputs::isWatched() {
  return asksForState() || topics_.tf.subscribers() > 0 || live_markers_.hasSubscribers();
}

/// Whether ~states, ~contacts, ~law_forces or a topic of a single body has subscribers, which is
/// looked up again after somebody has come or gone.
bool Outputs::asksForState() {
  const std::optional<std::size_t> changes =
      topics_.changes ? std::optional<std::size_t>(topics_.changes()) : std::nullopt;
  if (!changes || changes != asked_changes_) findAsked();
  asked_changes_ = changes;
  return asks_for_state_;
}

void Outputs::findAsked() {
  asked_.clear();
  for (const BodyTopics& topics : topics_.bodies)
    if (topics.odometry.subscribers() > 0 || topics.acceleration.subscribers() > 0 ||
        topics.applied_wrench.subscribers() > 0 || topics.actuators.hasSubscribers() ||
        topics.pivot_force.hasSubscribers())
      asked_.push_back(&topics);
  asks_for_state_ = !asked_.empty() || topics_.states.subscribers() > 0 ||
                    contacts_.hasSubscribers() || topics_.law_forces.hasSubscribers();
}

/// What asksForState has found to be asked for.
void Outputs::publishBodyTopics(const Snapshot& snapshot, const ros::Time& stamp) {
  if (topics_.states.subscribers()) {
    setStates(snapshot, stamp);
    topics_.states.publish(states_, stamp);
  }
  if (contacts_.hasSubscribers()) contacts_.publish(snapshot, stamp);
  if (topics_.law_forces.hasSubscribers())
    topics_.law_forces.publish(toLawForces(snapshot, messages_.worldFrame(), stamp), stamp);
  for (const BodyTopics* of_body : asked_) {
    const BodyTopics& topics = *of_body;
    if (isAbsent(topics.body)) continue;
    if (topics.odometry.subscribers())
      topics.odometry.publish(messages_.odometry(topics.body, snapshot, stamp), stamp);
    if (topics.applied_wrench.subscribers())
      topics.applied_wrench.publish(messages_.appliedWrench(topics.body, snapshot, stamp), stamp);
    if (topics.actuators.hasSubscribers())
      topics.actuators.publish(messages_.actuators(topics.body, snapshot, stamp), stamp);
  }
  publishMotions(snapshot, stamp);
}

/// All at once: bodies that act on one another share the work.
void Outputs::publishMotions(const Snapshot& snapshot, const ros::Time& stamp) {
  std::vector<const BodyTopics*> asked;
  std::vector<std::size_t> bodies;
  for (const BodyTopics* topics : asked_) {
    if (isAbsent(topics->body)) continue;
    if (!topics->acceleration.subscribers() && !topics->pivot_force.hasSubscribers()) continue;
    asked.push_back(topics);
    bodies.push_back(topics->body);
  }
  if (asked.empty()) return;
  const std::vector<BodyMotion> motions = snapshot.motions(bodies);
  for (std::size_t k = 0; k < asked.size(); ++k) {
    const BodyTopics& topics = *asked[k];
    if (topics.acceleration.subscribers())
      topics.acceleration.publish(messages_.acceleration(bodies[k], snapshot, motions[k], stamp),
                                  stamp);
    if (topics.pivot_force.hasSubscribers())
      topics.pivot_force.publish(messages_.pivotForce(bodies[k], snapshot, motions[k], stamp),
                                 stamp);
  }
}

void Outputs::setStates(const Snapshot& snapshot, const ros::Time& stamp) {
  setBodyStates(snapshot.world(), present_, snapshot.bodies(), stamp, states_);
}

}  // namespace rigid_body_sim
