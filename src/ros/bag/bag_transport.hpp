#pragma once

#include <algorithm>
#include <string>

#include <boost/make_shared.hpp>
#include <ros/message_traits.h>
#include <rosbag/bag.h>

#include "ros/outputs/topic.hpp"

namespace rigid_body_sim {

/// Topics that are written to a bag, at their stamps, under the names they have for a node
/// /rigid_body_node. See openTopics.
class BagTransport {
 public:
  /// The bag is open for writing and outlives the topics.
  explicit BagTransport(rosbag::Bag& bag) : bag_(bag) {}

  template <class Message>
  Topic<Message> open(const std::string& name, bool latched) {
    const std::string path = resolved(name);
    const boost::shared_ptr<ros::M_string> header = connectionHeader<Message>(path, latched);
    return {[] { return 1; },
            [&bag = bag_, path, header](const Message& message, const ros::Time& stamp) {
              // a bag has no time zero
              bag.write(path, std::max(stamp, ros::TIME_MIN), message, header);
            },
            [](const typename Topic<Message>::Greeting&) {}};
  }

 private:
  static std::string resolved(const std::string& name) {
    const std::string node = "/rigid_body_node/";
    if (name[0] == '~') return node + name.substr(1);
    return name[0] == '/' ? name : "/" + name;
  }

  /// As roscpp makes it; rosbag play latches what it says is latched.
  template <class Message>
  static boost::shared_ptr<ros::M_string> connectionHeader(const std::string& path, bool latched) {
    namespace traits = ros::message_traits;
    auto header = boost::make_shared<ros::M_string>();
    (*header)["topic"] = path;
    (*header)["callerid"] = "/rigid_body_node";
    (*header)["type"] = traits::datatype<Message>();
    (*header)["md5sum"] = traits::md5sum<Message>();
    (*header)["message_definition"] = traits::definition<Message>();
    (*header)["latching"] = latched ? "1" : "0";
    return header;
  }

  rosbag::Bag& bag_;
};

}  // namespace rigid_body_sim
