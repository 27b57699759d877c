#include "ros/outputs/law_forces.hpp"

#include <algorithm>
#include <limits>

#include "ros/outputs/arrow_markers.hpp"

namespace rigid_body_sim {
namespace {

using visualization_msgs::Marker;

constexpr double kWidth = 0.03;  // of a body's size

std::string nameAt(const LineForce::End& end, const World& world) {
  return end.body == kWorld ? std::string() : world.bodies[end.body].name;
}

LawForce toMessage(const LineForce& line, const World& world) {
  LawForce message;
  message.law = world.laws[line.law]->name();
  message.from = nameAt(line.from, world);
  message.to = nameAt(line.to, world);
  message.from_position = toPoint(line.from.position_W);
  message.to_position = toPoint(line.to.position_W);
  message.length = line.length;
  message.tension = line.tension;
  message.slack = line.is_slack;
  return message;
}

/// Grey and faint where it is slack, red where it pulls, blue where it pushes.
std_msgs::ColorRGBA colorOf(const LineForce& line) {
  std_msgs::ColorRGBA color;
  color.r = line.is_slack ? 0.6F : line.tension < 0 ? 0.2F : 0.9F;
  color.g = line.is_slack ? 0.6F : line.tension < 0 ? 0.4F : 0.3F;
  color.b = line.is_slack ? 0.6F : line.tension < 0 ? 0.9F : 0.1F;
  color.a = line.is_slack ? 0.4F : 1;
  return color;
}

}  // namespace

LawForces toLawForces(const Snapshot& snapshot, const std::string& world_frame,
                      const ros::Time& stamp) {
  LawForces message;
  message.header.frame_id = world_frame;
  message.header.stamp = stamp;
  for (const LineForce& line : snapshot.lineForces())
    message.forces.push_back(toMessage(line, snapshot.world()));
  return message;
}

Marker lineMarker(const LineForce& line, const World& world) {
  double size = std::numeric_limits<double>::infinity();
  for (const LineForce::End* end : {&line.from, &line.to})
    if (end->body != kWorld) size = std::min(size, sizeOf(world.bodies[end->body]));
  Marker marker;
  marker.type = Marker::LINE_STRIP;
  marker.ns = std::string("law/") + world.laws[line.law]->name();
  marker.points = {toPoint(line.from.position_W), toPoint(line.to.position_W)};
  marker.pose.orientation.w = 1;
  marker.scale.x = kWidth * size;
  marker.color = colorOf(line);
  return marker;
}

}  // namespace rigid_body_sim
