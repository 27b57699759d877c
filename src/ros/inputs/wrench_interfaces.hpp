#pragma once

#include <map>
#include <string>
#include <vector>

#include <ros/node_handle.h>

#include <rigid_body_sim/ApplyWrench.h>
#include <rigid_body_sim/ApplyWrenches.h>
#include <rigid_body_sim/ClearWrenches.h>

#include "ros/inputs/input_context.hpp"
#include "ros/inputs/wrench_intake.hpp"
#include "ros/options/node_options.hpp"

namespace rigid_body_sim {

/// The topics and services by which wrenches come in and end: <body>/wrench of every body that
/// moves, ~wrench, ~wrenches, ~apply_wrench, ~apply_wrenches, ~clear_wrenches; and /tf_static, for
/// frames that wrenches name. Each message is applied in order of arrival, by whoever serves the
/// queue of the handles; those of the lockstep in their turn.
class WrenchInterfaces {
 public:
  /// On a body, acting or to come, beside those of the scene: a sender without end must not fill
  /// the memory, nor the time.
  static constexpr std::size_t kMaxWrenches = 1000;

  WrenchInterfaces(const ros::NodeHandle& nh, const ros::NodeHandle& private_nh, const Scene& scene,
                   const InputContext& context, const NodeOptions& options);

  /// Takes in a body of the world: its frames and, where it moves, its topic. Gives it back.
  void add(const BodyDef& def, std::size_t body);
  void remove(const std::string& body);

  /// To be called after every input: it may have changed mass properties, and principal frames with
  /// them.
  void followBodies() { intake_.setBodies(context_.simulation.world().bodies); }

 private:
  using BodyWrench = geometry_msgs::WrenchStamped;

  void subscribe(const std::string& body);
  bool apply(ApplyWrench::Request& request, ApplyWrench::Response& response);
  bool applyAll(ApplyWrenches::Request& request, ApplyWrenches::Response& response);
  bool clear(ClearWrenches::Request& request, ClearWrenches::Response& response);
  std::string take(const std::string& body, const BodyWrench& message);
  std::string take(const std::vector<AppliedWrench>& messages, bool is_list);
  void requireRoom(const std::vector<WrenchInput>& inputs, bool is_list) const;

  ros::NodeHandle nh_;
  InputContext context_;
  WrenchIntake intake_;
  std::vector<std::size_t> wrenches_of_scene_;          // by body
  std::map<std::string, ros::Subscriber> body_topics_;  // by body
  ros::Subscriber wrench_, wrenches_;
  ros::Subscriber tf_static_;
  ros::ServiceServer apply_, apply_all_;
  ros::ServiceServer clear_;
};

}  // namespace rigid_body_sim
