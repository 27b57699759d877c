#pragma once

#include <array>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include <XmlRpcValue.h>

namespace rigid_body_sim {

/// The private parameters of the node. Each is read here and nowhere else.
struct NodeOptions {
  static constexpr double kMaxRate = 1e9;  ///< [Hz] stamps are whole nanoseconds

  std::string scene_file;        ///< path of the scene; empty when scene_text is given
  std::string scene_text;        ///< the scene itself, YAML; empty when scene_file is given
  double publish_rate = 100;     ///< [Hz] of simulation time, 0 < rate <= kMaxRate
  double clock_rate = 100;       ///< [Hz] of simulation time, 0 < rate <= kMaxRate
  bool publish_clock = false;    ///< time starts at 0 and is sent on /clock
  double real_time_factor = 1;   ///< simulated / wall time, >= 0; 0: as fast as possible
  double wrench_timeout = 0.5;   ///< [s] of simulation time, >= 0; 0: held for ever
  double command_timeout = 0.5;  ///< [s] of simulation time, >= 0; 0: held for ever
  bool body_topics = true;       ///< false: no topics of single bodies
  std::string tf_prefix;         ///< of the frames of bodies and points; empty: none
  std::array<double, 6> odometry_covariance{};  ///< diagonal of pose and of twist, >= 0
  std::vector<std::string> lockstep;  ///< topics with which time goes in step; empty: none
  double lockstep_period = 0;         ///< [s] of simulation time; > 0 with topics, 0 without
  double lockstep_timeout = 0;        ///< [s] of wall time, >= 0; 0: waits for ever
  bool reset_time = false;            ///< reset starts time again; with publish_clock only
  bool start_paused = false;
  std::optional<double> start_time;  ///< [s] where simulation time zero lies on a clock that is
                                     ///< followed; none: what the clock first says
  bool follow_clock = false;         ///< no parameter: /use_sim_time without publish_clock
};

/// A parameter that breaks its rule; what() is one line with name, value and rule.
class ParameterError : public std::invalid_argument {
 public:
  ParameterError(const std::string& line, const std::vector<std::string>& at_fault)
      : std::invalid_argument(line), parameters(at_fault) {}
  std::vector<std::string> parameters;  ///< names of those that were given and are at fault
};

/// Names of all parameters, in alphabetical order.
std::vector<std::string> parameterNames();

/// Options from the node's private parameters, a struct by name. Throws ParameterError for an
/// unknown name, a wrong type (an int will do for a double) or a value outside its rule.
NodeOptions toNodeOptions(const XmlRpc::XmlRpcValue& parameters);

/// Which clock this node goes by, as /use_sim_time says that every node does: its own, of wall
/// time; its own, that it sends to all (publish_clock); or that of another (follow_clock, set
/// here). Throws ParameterError for options that do not go with it.
void settleClock(NodeOptions& options, bool use_sim_time);

/// The line of an error; for a parameter that the command line did not give also how to delete it
/// from the master, where it stays when the node that it was given to has ended.
std::string describe(const ParameterError& error, const std::string& node,
                     const std::set<std::string>& given);

/// Reads the parameter server. given: parameters on the command line, for messages. Needs
/// ros::init.
NodeOptions loadNodeOptions(const std::set<std::string>& given);

}  // namespace rigid_body_sim
