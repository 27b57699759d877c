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
      origin_(origin),
      shown_(simulation, origin),
      within_(options.publish_rate),
      messages_(scene, options),
      body_outputs_(messages_, shown_),
      publish_clock_(options.publish_clock),
      state_instants_(options.publish_rate, simulation.time()),
      clock_instants_(options.clock_rate, simulation.time()),
      marker_instants_(std::min(options.publish_rate, kMarkerRate), simulation.time()),
      contacts_(topics_.contacts, scene.world_frame, origin),
      imus_(origin),
      live_markers_(topics_.live_markers, scene.world_frame, messages_.frames().bodies()),
      markers_(topics_.markers, toMarkers(scene, messages_.frames())) {
  std::vector<std::optional<BodyTopics>> of_body(simulation.world().bodies.size());
  for (BodyTopics& own : std::exchange(topics_.bodies, {})) of_body[own.body] = std::move(own);
  for (std::size_t i = 0; i < of_body.size(); ++i) take(i, std::move(of_body[i]));
  listBodies();
  publishOnce();
  greet();
}

void Outputs::publishOnce() {
  const ros::Time stamp = origin_.stamp(shown_.simulation().time());
  const tf2_msgs::TFMessage frames = messages_.fixedTransforms(shown_.simulation(), stamp);
  if (!frames.transforms.empty()) topics_.tf_static.publish(frames, stamp);
  markers_.publish(absentBodies(), stamp);
}

/// Who comes while time stands is sent the standing state.
void Outputs::greet() {
  topics_.tf.greetWith(shown_.greeting([this](const Snapshot& snapshot, const ros::Time& stamp) {
    greeted_ = stamp;
    return messages_.transforms(bodies_.moving(), snapshot, stamp);
  }));
  topics_.states.greetWith(
      shown_.greeting([this](const Snapshot& snapshot, const ros::Time& stamp) {
        setStates(snapshot, stamp);
        return states_;
      }));
  contacts_.greetWith(shown_.greeting([this](const Snapshot& snapshot, const ros::Time& stamp) {
    return contacts_.standing(snapshot, stamp);
  }));
  if (!topics_.law_forces.greetWith) return;
  topics_.law_forces.greetWith(
      shown_.greeting([this](const Snapshot& snapshot, const ros::Time& stamp) {
        return toLawForces(snapshot, messages_.worldFrame(), stamp);
      }));
}

double Outputs::nextOfAll() const {
  const double t = std::min(state_instants_.next(), imus_.next());
  return publish_clock_ ? std::min(t, clock_instants_.next()) : t;
}

/// Touches and releases are those of single steps.
double Outputs::nextInstant() const {
  const bool has_changes = contacts_.hasSubscribers() && hasContact(shown_.world());
  return has_changes ? shown_.simulation().time() : nextOfAll();
}

std::optional<double> Outputs::instantWithinStep() const {
  const double h = shown_.world().solver.time_step;
  const double t_end = static_cast<double>(shown_.simulation().steps() + 1) * h;
  const double t = nextOfAll();
  if (t < t_end - instantRounding(t_end, h)) return t;
  return std::nullopt;
}

void Outputs::publishInstant(double t) { publishAt(t, t); }

void Outputs::publishWithinStep(double t_end) {
  const double rounding = instantRounding(t_end, shown_.world().solver.time_step);
  const double reach = t_end + rounding;
  // where nobody looks they are none of a long step's work; those of its end are due after it
  if (!isWatched())
    for (Instants* instants : {&state_instants_, &marker_instants_})
      instants->passTo(t_end - rounding);
  for (auto t = instantWithinStep(); t && *t <= reach; t = instantWithinStep()) publishInstant(*t);
}

void Outputs::publishDue() {
  const double t = shown_.simulation().time();
  contacts_.keepChanges(shown_.simulation());
  publishAt(t, t + instantRounding(t, shown_.world().solver.time_step));
}

/// Publishes at time t [s] what is due at instants up to `reach`.
void Outputs::publishAt(double t, double reach) {
  if (publish_clock_ && clock_instants_.next() <= reach) {
    clock_instants_.passTo(reach);
    publishClock(t);
  }
  if (imus_.publishDue(shown_.simulation(), t, reach)) shown_.note(t);
  if (state_instants_.next() <= reach) {
    state_instants_.passTo(reach);
    const bool with_markers = marker_instants_.next() <= reach;
    marker_instants_.passTo(reach);
    publishState(t, with_markers);
  }
}

void Outputs::publishNow() {
  if (publish_clock_) publishClock(shown_.simulation().time());
  publishState(shown_.simulation().time(), true);
}

void Outputs::repeatClock() {
  if (!publish_clock_) return;
  rosgraph_msgs::Clock message;
  message.clock = origin_.stamp(shownTime());
  topics_.clock.publish(message, message.clock);
}

void Outputs::repeatState() {
  if (!asksForState()) return;
  const Snapshot snapshot = shown_.snapshot();
  publishAsked(snapshot, origin_.stamp(snapshot.time()));
}

void Outputs::repeatBodies() { markers_.repeat(origin_.stamp(shown_.simulation().time())); }

void Outputs::restart(double t) {
  takeInput();
  shown_.restart();
  greeted_.reset();
  contacts_.restart();
  imus_.restart(t);
  for (Instants* instants : {&state_instants_, &clock_instants_, &marker_instants_})
    instants->restart(t);
}

void Outputs::publishClock(double t) {
  const std::optional<ros::Time> stamp = shown_.takeClock(t);
  if (!stamp) return;
  rosgraph_msgs::Clock message;
  message.clock = *stamp;
  topics_.clock.publish(message, message.clock);
}

void Outputs::publishState(double t, bool with_markers) {
  const std::optional<ros::Time> taken = shown_.takeState(t);
  if (!taken) return;
  const ros::Time& stamp = *taken;
  const bool seen = live_markers_.hasSubscribers();
  if (!seen) live_markers_.forget();
  if (!asksForState() && !topics_.tf.subscribers() && !(seen && with_markers)) return;
  const Snapshot snapshot(shown_.simulation(), within_, t);
  if (topics_.tf.subscribers() && stamp != greeted_) {
    const tf2_msgs::TFMessage frames = messages_.transforms(bodies_.moving(), snapshot, stamp);
    if (!frames.transforms.empty()) topics_.tf.publish(frames, stamp);
  }
  publishAsked(snapshot, stamp);
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
  if (!changes || changes != asked_changes_) {
    body_outputs_.findAsked();
    asks_for_state_ = body_outputs_.areAsked() || topics_.states.subscribers() > 0 ||
                      contacts_.hasSubscribers() || topics_.law_forces.hasSubscribers();
  }
  asked_changes_ = changes;
  return asks_for_state_;
}

/// What asksForState has found to be asked for.
void Outputs::publishAsked(const Snapshot& snapshot, const ros::Time& stamp) {
  if (topics_.states.subscribers()) {
    setStates(snapshot, stamp);
    topics_.states.publish(states_, stamp);
  }
  if (contacts_.hasSubscribers()) contacts_.publish(snapshot, stamp);
  if (topics_.law_forces.hasSubscribers())
    topics_.law_forces.publish(toLawForces(snapshot, messages_.worldFrame(), stamp), stamp);
  body_outputs_.publish(snapshot, stamp);
}

void Outputs::setStates(const Snapshot& snapshot, const ros::Time& stamp) {
  setBodyStates(snapshot.world(), bodies_.present(), snapshot.bodies(), stamp, states_);
}

}  // namespace rigid_body_sim
