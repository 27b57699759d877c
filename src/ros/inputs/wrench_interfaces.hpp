#pragma once

#include <map>
#include <string>
#include <vector>

#include <ros/node_handle.h>

#include <rigid_body_sim/ApplyWrench.h>
#include <rigid_body_sim/ClearWrenches.h>

#include "ros/inputs/inputs.hpp"
#include "ros/inputs/refusals.hpp"
#include "ros/inputs/wrench_intake.hpp"
#include "ros/options/node_options.hpp"

namespace rigid_body_sim {

/// The topics and services by which wrenches come in and end: <body>/wrench of every body that
/// moves, ~wrench, ~apply_wrench, ~clear_wrenches; and /tf_static, for frames that wrenches name.
/// Each message is applied in order of arrival, by whoever serves the queue of the handles.
class WrenchInterfaces {
 public:
  /// On a body, acting or to come, beside those of the scene: a sender without end must not fill
  /// the memory, nor the time.
  static constexpr std::size_t kMaxWrenches = 1000;

  /// Simulation, inputs and refusals are referred to, not copied.
  WrenchInterfaces(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh, const Scene& scene,
                   const Simulation& simulation, Inputs& inputs, const TimeOrigin& origin,
                   const NodeOptions& options, Refusals& refusals);

  /// Takes in a body of the world: its frames and, where it moves, its topic. Gives it back.
  void add(const BodyDef& def, std::size_t body);
  void remove(const std::string& body);

 private:
  using BodyWrench = geometry_msgs::WrenchStamped;

  void subscribe(const std::string& body);
  bool apply(ApplyWrench::Request& request, ApplyWrench::Response& response);
  bool clear(ClearWrenches::Request& request, ClearWrenches::Response& response);
  template <class... Message>
  std::string take(const Message&... message);
  void requireRoom(const WrenchInput& input) const;

  ros::NodeHandle nh_;
  const Simulation& simulation_;
  Inputs& inputs_;
  const TimeOrigin& origin_;
  Refusals& refusals_;
  WrenchIntake intake_;
  std::vector<std::size_t> wrenches_of_scene_;          // by body
  std::map<std::string, ros::Subscriber> body_topics_;  // by body
  ros::Subscriber wrench_;
  ros::Subscriber tf_static_;
  ros::ServiceServer apply_;
  ros::ServiceServer clear_;
};

}  // namespace rigid_body_sim
