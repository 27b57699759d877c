#pragma once

#include <string>

#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

#include <rigid_body_sim/scene/frames.hpp>

namespace rigid_body_sim {

/// The frames that others tell of on /tf_static.
class StaticFrames {
 public:
  void add(const tf2_msgs::TFMessage& message);

  /// Puts a frame that the table does not have, but that hangs on one of the table's by static
  /// transforms, into the table; there it stays as it was when looked up.
  void lookUp(const std::string& name, FrameTable& table) const;

 private:
  tf2::BufferCore buffer_;
};

}  // namespace rigid_body_sim
