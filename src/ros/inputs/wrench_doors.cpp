#include "ros/inputs/wrench_doors.hpp"

#include <rigid_body_sim/ApplyWrench.h>
#include <rigid_body_sim/ClearWrenches.h>

#include "ros/inputs/wrench_messages.hpp"

namespace rigid_body_sim {
namespace {

/// Messages that may wait for the next step boundary: a tenth of a second at 10 000 a second.
constexpr std::uint32_t kWrenchQueue = 1000;

template <class Message>
ros::Subscriber subscribe(ros::NodeHandle& nh, const std::string& topic,
                          const boost::function<void(const boost::shared_ptr<const Message>&)>& f) {
  return nh.subscribe<Message>(topic, kWrenchQueue, f, ros::VoidConstPtr(),
                               ros::TransportHints().tcpNoDelay());
}

template <class Service>
using Answer = boost::function<bool(typename Service::Request&, typename Service::Response&)>;

Answer<ApplyWrench> answering(const TimeOrigin& origin, const WrenchDoors::Sink& sink) {
  return [&origin, sink](ApplyWrench::Request& request, ApplyWrench::Response& response) {
    response.message = sink(toRequest(request.wrench, origin));
    response.success = response.message.empty();
    return true;
  };
}

Answer<ClearWrenches> answering(const WrenchDoors::Clear& clear) {
  return [clear](ClearWrenches::Request& request, ClearWrenches::Response& response) {
    const WrenchDoors::Cleared cleared = clear(request.body, slotOfId(request.id));
    response.success = cleared.fault.empty();
    response.message = response.success ? "ended: " + std::to_string(cleared.count) : cleared.fault;
    return true;
  };
}

}  // namespace

WrenchDoors::WrenchDoors(ros::NodeHandle nh, ros::NodeHandle private_nh,
                         const std::vector<std::string>& bodies, const TimeOrigin& origin,
                         const Sink& sink, const Clear& clear) {
  using Everyday = geometry_msgs::WrenchStamped;
  for (const std::string& body : bodies) {
    subscribers_.push_back(subscribe<Everyday>(
        nh, body + "/wrench",
        [body, sink](const Everyday::ConstPtr& message) { sink(toRequest(body, *message)); }));
  }
  subscribers_.push_back(subscribe<AppliedWrench>(
      private_nh, "wrench", [&origin, sink](const AppliedWrench::ConstPtr& message) {
        sink(toRequest(*message, origin));
      }));
  services_.push_back(private_nh.advertiseService("apply_wrench", answering(origin, sink)));
  services_.push_back(private_nh.advertiseService("clear_wrenches", answering(clear)));
}

}  // namespace rigid_body_sim
