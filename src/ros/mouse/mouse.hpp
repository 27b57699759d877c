#pragma once

#include <map>
#include <string>
#include <vector>

#include <visualization_msgs/InteractiveMarkerFeedback.h>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "ros/inputs/inputs.hpp"
#include "ros/mouse/mouse_spring.hpp"
#include "ros/mouse/pose_history.hpp"

namespace rigid_body_sim {

/// The bodies that viewers hold with the mouse by their handles (toHandles), and the springs that
/// pull them. A body is held by the viewer that pressed last, at the point that was pressed.
class Mouse {
 public:
  /// wrench_timeout [s of simulation time]: how long a body is pulled without feedback; 0: for
  /// ever. tf_frames: of the bodies, by body; empty: their names. Simulation and inputs are
  /// referred to, not copied.
  Mouse(const Simulation& simulation, Inputs& inputs, double wrench_timeout,
        std::vector<std::string> tf_frames = {});

  /// Takes in a body of the world that moves; gives it back, and ends its pull.
  void add(std::size_t body);
  void remove(std::size_t body);

  /// Why feedback, a choice in a menu, too, is of no handle that a viewer shows: its handle is
  /// unknown, its body absent, or its frame not that of the body. Empty where it is of one.
  std::string faultOf(const visualization_msgs::InteractiveMarkerFeedback& feedback) const;

  /// Takes what a viewer reports: a button pressed on a handle, the handle dragged or kept where it
  /// is, the button released. Returns the fault of feedback that is refused and changes nothing:
  /// as faultOf, or for a pull that is not finite.
  std::string take(const visualization_msgs::InteractiveMarkerFeedback& feedback);

  /// Applies, for the next step, the pull on every body that is held, each in a slot of its own.
  /// Returns the fault of a pull that the simulation refuses; that body is held no longer.
  std::string pull();

  /// An input has been applied: a body whose wrenches have all been cleared, that has been reset,
  /// or that has left, is held no longer. A handle that is still being dragged does nothing until
  /// it is pressed again. A body of another mass is held at the same point.
  void follow(const SimulationInput& input);

 private:
  struct Hold {
    std::string client;  // of the viewer
    Vector3d point_B;    // [m]
    MouseSpring spring;
    double until = 0;  // [s] the pull ends, unless there is feedback before
    PoseHistory poses;
  };
  using Feedback = visualization_msgs::InteractiveMarkerFeedback;

  std::string press(std::size_t body, const Feedback& feedback);
  std::string drag(Hold& hold, const Feedback& feedback);
  std::string pull(Hold& hold);
  void release(std::size_t body);
  void note(Hold& hold) const;

  const Simulation& simulation_;
  Inputs& inputs_;
  double wrench_timeout_;
  std::vector<std::string> tf_frames_;                // by body; empty: their names
  std::map<std::string, std::size_t> moving_bodies_;  // by name
  std::map<std::size_t, Hold> holds_;                 // by body
};

}  // namespace rigid_body_sim
