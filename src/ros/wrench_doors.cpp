#include "wrench_doors.hpp"

#include "wrench_messages.hpp"

namespace rigid_body_sim {
namespace {

/// Messages that may wait for the next step boundary: a tenth of a second at 10 000 a second.
constexpr std::uint32_t kQueueSize = 1000;

template <class Message>
ros::Subscriber subscribe(ros::NodeHandle& nh, const std::string& topic,
                          const boost::function<void(const boost::shared_ptr<const Message>&)>& f) {
  return nh.subscribe<Message>(topic, kQueueSize, f, ros::VoidConstPtr(),
                               ros::TransportHints().tcpNoDelay());
}

}  // namespace

WrenchDoors::WrenchDoors(ros::NodeHandle nh, ros::NodeHandle private_nh,
                         const std::vector<std::string>& bodies, const TimeOrigin& origin,
                         const Sink& sink) {
  using Everyday = geometry_msgs::WrenchStamped;
  for (const std::string& body : bodies) {
    subscribers_.push_back(subscribe<Everyday>(
        nh, body + "/wrench",
        [body, sink](const Everyday::ConstPtr& message) { sink(toRequest(body, *message)); }));
  }
  subscribers_.push_back(subscribe<AppliedWrench>(
      private_nh, "wrench", [origin, sink](const AppliedWrench::ConstPtr& message) {
        sink(toRequest(*message, origin));
      }));
}

}  // namespace rigid_body_sim
