#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include <geometry_msgs/WrenchStamped.h>
#include <tf2_msgs/TFMessage.h>

#include <rigid_body_sim/AppliedWrenches.h>
#include <rigid_body_sim/dynamics/input.hpp>
#include <rigid_body_sim/scene/frames.hpp>

#include "ros/inputs/static_frames.hpp"
#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {

/// Does something with the wrench of that number in a list; what it throws says which it is.
template <class Action>
void withPlace(std::size_t number, const Action& action) {
  try {
    action();
  } catch (const std::invalid_argument& fault) {
    throw std::invalid_argument("wrenches[" + std::to_string(number) + "]: " + fault.what());
  }
}

/// The slot of an id of AppliedWrench on its body; empty for none. <body>/wrench uses others.
std::string slotOfId(const std::string& id);

/// Turns wrench messages into inputs of the core: names and frames are resolved, and the rules of
/// the two interfaces checked, here and once.
///
/// take() throws std::invalid_argument, one line, for a name that is unknown, a number that is not
/// finite, a duration that is negative or has no slot to hold it in, an id that is too long, and,
/// on <body>/wrench, a frame that is neither the world's nor fixed to that body.
class WrenchIntake {
 public:
  /// wrench_timeout [s]: after its start, a wrench of duration 0 ends; 0: never. The bodies, those
  /// of the scene's world, are referred to, not copied, until others are set.
  /// Messages may name the frames of tf_prefix (TfFrames) and those of the scene.
  WrenchIntake(const Scene& scene, const std::vector<Body>& bodies, double wrench_timeout,
               const std::string& tf_prefix = "");

  /// Takes in the frames of a body of the world; gives them back.
  void add(const BodyDef& def, std::size_t body) { frames_.add(def, (*bodies_)[body], body); }
  void remove(const std::string& body) { frames_.remove(body); }

  /// The world is another: these are its bodies now.
  void setBodies(const std::vector<Body>& bodies);

  /// Frames that others hang on those of the scene; each is looked up when first named.
  void addStatic(const tf2_msgs::TFMessage& frames) { static_frames_.add(frames); }

  /// A message on <body>/wrench that arrives at simulation time `now` [s]: acts from then on. Each
  /// frame has a slot of its own, and says where the wrench acts: the world's at the centre of
  /// mass, another at its origin.
  WrenchInput take(const std::string& body, const geometry_msgs::WrenchStamped& message,
                   double now);

  /// A message on ~wrench: each id has a slot of its own. A start of zero or in the past is now.
  WrenchInput take(const AppliedWrench& message, const TimeOrigin& origin, double now);

  /// Those of a message on ~wrenches, likewise; what is thrown says which of them is at fault.
  std::vector<WrenchInput> take(const std::vector<AppliedWrench>& messages,
                                const TimeOrigin& origin, double now);

 private:
  PointWrench resolved(const WrenchDef& wrench) const;
  void requireFixedToBody(const WrenchDef& wrench) const;
  double heldFor() const;

  const std::vector<Body>* bodies_;
  std::string world_frame_;
  double wrench_timeout_;
  FrameTable frames_;
  StaticFrames static_frames_;
};

}  // namespace rigid_body_sim
