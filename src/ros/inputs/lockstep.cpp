#include "ros/inputs/lockstep.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <ros/console.h>
#include <ros/names.h>
#include <ros/this_node.h>
#include <ros/topic_manager.h>

#include "math/shortest.hpp"
#include "ros/inputs/message_limits.hpp"
#include "ros/inputs/stamped_message.hpp"

namespace rigid_body_sim {

Lockstep::Lockstep(const NodeOptions& options, double time_step)
    : timeout_(options.lockstep_timeout) {
  for (const std::string& name : options.lockstep) {
    const std::string full = ros::names::resolve(name);
    const auto is_same = [&full](const Topic& topic) { return topic.name == full; };
    if (std::none_of(topics_.begin(), topics_.end(), is_same)) topics_.push_back({full});
  }
  if (topics_.empty()) return;
  const double steps = options.lockstep_period / time_step;
  every_ = static_cast<std::int64_t>(std::llround(steps));
  if (every_ < 1 || std::abs(steps - static_cast<double>(every_)) > 1e-9 * steps)
    throw ParameterError(
        "parameter ~lockstep_period: must be a multiple of the scene's time_step " +
            shortest(time_step) + " s, got " + shortest(options.lockstep_period),
        {"lockstep_period"});
}

bool Lockstep::take(const std::string& topic) {
  for (Topic& known : topics_)
    if (known.name == topic) return known.is_taken = true;
  return false;
}

void Lockstep::refuseOwn() const {
  std::vector<std::string> own;
  ros::this_node::getAdvertisedTopics(own);
  for (const Topic& topic : topics_)
    if (std::find(own.begin(), own.end(), topic.name) != own.end())
      throw ParameterError(
          "parameter ~lockstep: must name topics of others, such as a "
          "controller's, but this node itself publishes " +
              topic.name,
          {"lockstep"});
}

void Lockstep::watchOthers(ros::NodeHandle nh) {
  refuseOwn();
  for (Topic& topic : topics_) {
    if (topic.is_taken) continue;
    const std::string name = topic.name;
    using Event = ros::MessageEvent<const StampedMessage>;
    const boost::function<void(const Event&)> note = [this, name](const Event& event) {
      if (!beginsWithHeader(event.getConnectionHeader()))
        fault_ = "parameter ~lockstep: " + name + " must be of a type that begins with a Header";
      else
        hold(name, event.getMessage()->stamp, event.getMessage()->bytes, [] {});
    };
    ros::SubscribeOptions options;
    options.initByFullCallbackType<const Event&>(name, kMessageQueue, note);
    options.transport_hints = ros::TransportHints().tcpNoDelay();
    topic.subscriber = nh.subscribe(options);
  }
}

// Bounds the memory that a sender without stamps takes: minutes of its messages.
constexpr std::size_t kMaxAnswersHeld = 100000;

void Lockstep::hold(const std::string& topic, const ros::Time& stamp, std::string bytes,
                    Take take) {
  for (Topic& known : topics_) {
    if (known.name != topic || known.last_bytes == bytes) continue;
    const bool is_stale = known.stale_from && stamp >= *known.stale_from;
    known.stale_from.reset();  // messages keep their order: whatever comes later is of this run
    if (is_stale) return;
    if (known.held.size() >= kMaxAnswersHeld) {
      fault_ = "lockstep: " + topic + " has brought " + std::to_string(kMaxAnswersHeld) +
               " messages, none of them stamped as an answer to the state at hand";
      return;
    }
    known.last_bytes = std::move(bytes);
    known.is_received = true;
    known.held.push_back({stamp, std::move(take)});
    return;
  }
}

void Lockstep::begin(const ros::Time& state, Clock::time_point now) {
  state_ = state;
  begin_ = now;
  warned_ = false;
}

void Lockstep::restart() {
  for (Topic& topic : topics_) {
    const bool is_missing = state_ && endOfWait(topic) == topic.held.end();
    topic.stale_from = is_missing ? state_ : std::nullopt;
    // the state is sent again, should its answer be taken for the stale one
    topic.is_received = false;
    topic.held.clear();
    topic.last_bytes.clear();
    topic.last_end.reset();
  }
  state_.reset();
}

/// The message that ends the wait; the end where it is still to come.
std::deque<Lockstep::Held>::const_iterator Lockstep::endOfWait(const Topic& topic) const {
  return std::find_if(topic.held.begin(), topic.held.end(), [&](const Held& held) {
    return held.stamp >= *state_ && !(held.stamp <= topic.last_end);
  });
}

const Lockstep::Topic* Lockstep::firstMissing() const {
  for (const Topic& topic : topics_)
    if (endOfWait(topic) == topic.held.end()) return &topic;
  return nullptr;
}

bool Lockstep::mayHaveLostAnswer() {
  bool may_have = false;
  for (Topic& topic : topics_) {
    const auto publishers =
        static_cast<std::uint32_t>(ros::TopicManager::instance()->getNumPublishers(topic.name));
    if (publishers > topic.publishers) topic.is_received = false;
    topic.publishers = publishers;
    may_have |= publishers > 0 && !topic.is_received && endOfWait(topic) == topic.held.end();
  }
  return may_have;
}

void Lockstep::takeAll() {
  std::vector<Take> takes;
  for (Topic& topic : topics_) {
    const auto end = endOfWait(topic);
    topic.last_end = end->stamp;
    for (auto held = topic.held.cbegin(); held != end + 1; ++held) takes.push_back(held->take);
    topic.held.erase(topic.held.cbegin(), end + 1);
  }
  state_.reset();
  for (const Take& take : takes) take();
}

std::string Lockstep::missing() const {
  const Topic* late = firstMissing();
  const Topic& topic = late ? *late : topics_.front();
  std::ostringstream text;
  text << "a message on " << topic.name << " stamped ";
  if (topic.last_end < *state_) {  // also where there was none
    text << *state_ << " or later";
  } else {
    const double ahead = (*topic.last_end - *state_).toSec();
    text << "later than " << *topic.last_end << " (the stamp of the last one taken";
    if (ahead > kFarthestCommand)
      text << ", " << ahead << " s ahead of simulation time: of another clock?";
    text << ")";
  }
  return text.str();
}

std::chrono::milliseconds Lockstep::patience() const {
  constexpr double kDefault = 2, kMax = 1e6;  // [s]
  const double seconds = timeout_ > 0 ? std::min(timeout_, kMax) : kDefault;
  return std::chrono::milliseconds(static_cast<std::int64_t>(1000 * seconds));
}

void Lockstep::checkPatience(Clock::time_point now) {
  if (!fault_.empty()) throw std::runtime_error(fault_);
  const double waited = std::chrono::duration<double>(now - begin_).count();
  if (timeout_ > 0 && waited > timeout_)
    throw std::runtime_error("lockstep: " + missing() + " did not come within " +
                             shortest(timeout_) + " s of wall time (~lockstep_timeout)");
  if (waited < 1 || warned_) return;
  warned_ = true;
  ROS_WARN("lockstep: waiting for %s", missing().c_str());
}

}  // namespace rigid_body_sim
