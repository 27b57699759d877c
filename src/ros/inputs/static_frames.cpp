#include "ros/inputs/static_frames.hpp"

#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {
namespace {

/// More would be a loop.
constexpr int kMaxFrameDepth = 100;

Isometry3d toIsometry(const geometry_msgs::Transform& transform) {
  const geometry_msgs::Quaternion& q = transform.rotation;
  Isometry3d X = Isometry3d::Identity();
  X.linear() = Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  X.translation() = fromVector3(transform.translation);
  return X;
}

}  // namespace

void StaticFrames::add(const tf2_msgs::TFMessage& message) {
  for (const geometry_msgs::TransformStamped& transform : message.transforms)
    buffer_.setTransform(transform, "tf_static", true);
}

void StaticFrames::lookUp(const std::string& name, FrameTable& table) const {
  std::string root = name;
  for (int links = 0; !table.find(root); ++links) {
    const std::string child = root;
    if (links == kMaxFrameDepth || !buffer_._getParent(child, ros::Time(), root)) return;
  }
  if (root == name) return;
  table.attach(name, root, toIsometry(buffer_.lookupTransform(root, name, ros::Time()).transform));
}

}  // namespace rigid_body_sim
