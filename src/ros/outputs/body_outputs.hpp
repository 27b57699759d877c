#pragma once

#include <cstddef>
#include <vector>

#include "ros/outputs/body_messages.hpp"
#include "ros/outputs/output_topics.hpp"
#include "ros/outputs/shown_state.hpp"

namespace rigid_body_sim {

/// The topics of single bodies, but for those of IMUs: <body>/odom, <body>/accel,
/// <body>/applied_wrench, <body>/pivot_force and <body>/actuators. Only those with subscribers are
/// computed, of bodies that are present.
class BodyOutputs {
 public:
  /// Both are referred to, not copied.
  BodyOutputs(const BodyMessages& messages, const ShownState& shown)
      : messages_(messages), shown_(shown) {}

  /// Takes in a body that moves, by its topics; gives it back: they end. To be followed by
  /// findAsked.
  void add(BodyTopics topics);
  void remove(std::size_t body);

  /// Looks up which topics have subscribers; thousands take a while.
  void findAsked();

  /// As findAsked has found.
  bool areAsked() const { return !asked_.empty(); }
  void publish(const Snapshot& snapshot, const ros::Time& stamp) const;

 private:
  void greet(const BodyTopics& topics) const;
  void publishMotions(const Snapshot& snapshot, const ros::Time& stamp) const;

  const BodyMessages& messages_;
  const ShownState& shown_;
  std::vector<BodyTopics> topics_;
  std::vector<const BodyTopics*> asked_;  // those with subscribers
};

}  // namespace rigid_body_sim
