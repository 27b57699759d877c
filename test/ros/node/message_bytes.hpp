#pragma once

#include <string>
#include <vector>

#include <ros/serialization.h>

namespace rigid_body_sim {

/// What goes over the wire for a message with a header, but for the count that roscpp puts there.
template <class Message>
std::string bytesOf(Message message) {
  message.header.seq = 0;
  std::vector<std::uint8_t> buffer(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(buffer.data(), static_cast<std::uint32_t>(buffer.size()));
  ros::serialization::serialize(stream, message);
  return {buffer.begin(), buffer.end()};
}

}  // namespace rigid_body_sim
