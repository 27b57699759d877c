#pragma once

#include <cstdint>
#include <sstream>
#include <string>

#include <boost/shared_ptr.hpp>
#include <ros/message_traits.h>
#include <ros/serialization.h>

namespace rigid_body_sim {

/// Any message that begins with a Header, of which the stamp is read and nothing else understood.
struct StampedMessage {
  ros::Time stamp;
  std::string bytes;  ///< what follows the number of the header
};

/// Whether messages of a connection are of this kind, by its header.
inline bool beginsWithHeader(const ros::M_string& connection) {
  const auto found = connection.find("message_definition");
  std::istringstream lines(found == connection.end() ? "" : found->second);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string type;
    if (!(words >> type) || type[0] == '#') continue;
    return type == "Header" || type == "std_msgs/Header";
  }
  return false;
}

}  // namespace rigid_body_sim

namespace ros {
namespace message_traits {

template <>
struct MD5Sum<rigid_body_sim::StampedMessage> {
  static const char* value() { return "*"; }
  static const char* value(const rigid_body_sim::StampedMessage&) { return value(); }
};
template <>
struct DataType<rigid_body_sim::StampedMessage> {
  static const char* value() { return "*"; }
  static const char* value(const rigid_body_sim::StampedMessage&) { return value(); }
};

}  // namespace message_traits
namespace serialization {

template <>
struct Serializer<rigid_body_sim::StampedMessage> {
  template <class Stream>
  static void read(Stream& stream, rigid_body_sim::StampedMessage& message) {
    std::uint32_t number = 0;
    if (stream.getLength() < 12) {  // no header: the type shows that
      stream.advance(stream.getLength());
      return;
    }
    stream.next(number);
    const std::uint32_t length = stream.getLength();
    message.bytes.assign(reinterpret_cast<const char*>(stream.getData()), length);
    stream.next(message.stamp);
    stream.advance(length - 8);
  }
};

}  // namespace serialization
}  // namespace ros
