#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <ros/node_handle.h>
#include <ros/serialization.h>

#include "ros/options/node_options.hpp"

namespace rigid_body_sim {

/// Lets time go in step with messages: at every multiple of a period the run waits until each of
/// some topics has brought a message that is stamped no earlier than the state there, and later
/// than the one that ended the wait before. Whatever comes on these topics is held until then and
/// taken topic by topic, up to that message: so each message is taken over at the same step in
/// every run, however long it was on its way. A message that repeats the one before it, stamp and
/// all, is dropped: a subscriber that comes while time stands may be sent a state twice.
class Lockstep {
 public:
  using Clock = std::chrono::steady_clock;
  using Take = std::function<void()>;

  /// Throws ParameterError for a period that is no multiple of the time step [s].
  Lockstep(const NodeOptions& options, double time_step);

  /// Whether messages of that topic (its full name) are to be held; whoever asks holds them.
  bool take(const std::string& topic);

  /// Subscribes to those of the topics that nobody has taken: of them the stamps count alone.
  /// Throws ParameterError for a topic that this node publishes: it would answer itself, or never.
  void watchOthers(ros::NodeHandle nh);

  template <class Message>
  void hold(const std::string& topic, Message message, Take take) {
    const ros::Time stamp = message.header.stamp;
    message.header.seq = 0;  // counts what a publisher has sent: no part of what it says
    hold(topic, stamp, bytesOf(message), std::move(take));
  }
  void hold(const std::string& topic, const ros::Time& stamp, std::string bytes, Take take);

  bool isOn() const { return !topics_.empty(); }

  /// Whether the run is to wait at a step.
  bool isDueAt(std::int64_t step) const { return isOn() && step % every_ == 0; }

  /// The state with this stamp has been published, and is to be waited for from now on.
  void begin(const ros::Time& state, Clock::time_point now);

  /// The run does not wait any more, and what was held is of another run. An answer that is missing
  /// is on its way still: it is dropped when it comes, else it would answer a state of the new run.
  void restart();

  bool isWaiting() const { return state_.has_value(); }

  /// Whether each topic has brought its message.
  bool hasAll() const { return firstMissing() == nullptr; }

  /// Whether a message is missing of a publisher that has come since the topic brought its last
  /// one. It may have answered the state before its connection stood, and the answer be lost: then
  /// it is to be sent the state again.
  bool mayHaveLostAnswer();

  /// Takes the messages, once all are there, and ends the wait.
  void takeAll();

  /// Patience begins anew, after a pause.
  void restartPatience(Clock::time_point now) { begin_ = now; }

  /// Warns of a wait that is longer than a second, once; throws std::runtime_error, one line that
  /// names the topic, for one longer than the timeout.
  void checkPatience(Clock::time_point now);

  /// Why no message will ever do; empty where nothing is known against it.
  const std::string& fault() const { return fault_; }

  /// How long a caller of ~step may be expected to wait.
  std::chrono::milliseconds patience() const;

  /// What is waited for: "a message on /pilot/command stamped 0.02 or later". Only while it waits.
  std::string missing() const;

 private:
  struct Held {
    ros::Time stamp;
    Take take;
  };
  struct Topic {
    std::string name;
    bool is_taken = false;
    std::deque<Held> held{};
    std::string last_bytes{};               // of the last that was held
    std::optional<ros::Time> last_end{};    // stamp of the message that ended the last wait
    std::uint32_t publishers = 0;           // when they were last counted
    bool is_received = false;               // since the last of them came
    std::optional<ros::Time> stale_from{};  // see restart
    ros::Subscriber subscriber{};           // where nobody else takes it
  };

  template <class Message>
  static std::string bytesOf(const Message& message) {
    const ros::SerializedMessage serialized = ros::serialization::serializeMessage(message);
    return {reinterpret_cast<const char*>(serialized.buf.get()), serialized.num_bytes};
  }
  std::deque<Held>::const_iterator endOfWait(const Topic& topic) const;
  const Topic* firstMissing() const;
  void refuseOwn() const;

  std::vector<Topic> topics_;
  std::int64_t every_ = 1;          // steps
  double timeout_;                  // [s] of wall time; 0: none
  std::optional<ros::Time> state_;  // that is waited for
  Clock::time_point begin_;
  bool warned_ = false;  // in this wait
  std::string fault_;    // of a topic
};

}  // namespace rigid_body_sim
