#pragma once

#include <stdexcept>
#include <string>

#include <XmlRpcValue.h>

namespace rigid_body_sim {

/// The private parameters of the node. Each is read here and nowhere else.
struct NodeOptions {
  std::string scene_file;       ///< path of the scene; empty when scene_text is given
  std::string scene_text;       ///< the scene itself, YAML; empty when scene_file is given
  double publish_rate = 100;    ///< [Hz] of simulation time, > 0
  double clock_rate = 100;      ///< [Hz] of simulation time, > 0
  bool publish_clock = false;   ///< time starts at 0 and is sent on /clock
  double real_time_factor = 1;  ///< simulated / wall time, >= 0; 0: as fast as possible
  double wrench_timeout = 0.5;  ///< [s] of simulation time, >= 0; 0: held for ever
  bool reset_time = false;      ///< reset starts time again
  bool start_paused = false;
};

/// A parameter that breaks its rule; what() is one line with name, value and rule.
class ParameterError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Options from the node's private parameters, a struct by name. Throws ParameterError for an
/// unknown name, a wrong type (an int will do for a double) or a value outside its rule.
NodeOptions toNodeOptions(const XmlRpc::XmlRpcValue& parameters);

/// Throws ParameterError when the clock that this node would send and the one that every node is
/// told to follow are not the same: publish_clock needs /use_sim_time and the other way round.
void checkClockOptions(const NodeOptions& options, bool use_sim_time);

/// Reads the parameter server. Needs ros::init.
NodeOptions loadNodeOptions();

}  // namespace rigid_body_sim
