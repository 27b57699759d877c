#include <cstdio>
#include <cstdlib>

#include <ros/callback_queue.h>
#include <ros/ros.h>

#include <rigid_body_sim/BodyStates.h>

namespace {

int received = 0;

void serve(double seconds) {
  ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(seconds));
}

}  // namespace

/// Subscribes to the states of a node for some seconds. Prints when the first message came [s of
/// wall time], and how many came per second after it.
int main(int argc, char** argv) {
  ros::init(argc, argv, "states_load", ros::init_options::AnonymousName);
  if (argc != 2) {
    std::fprintf(stderr, "usage: states_load SECONDS\n");
    return 2;
  }
  const double seconds = std::atof(argv[1]);
  ros::NodeHandle nh;
  const boost::function<void(const rigid_body_sim::BodyStates&)> receive =
      [](const rigid_body_sim::BodyStates&) { ++received; };
  const ros::Subscriber subscriber =
      nh.subscribe<rigid_body_sim::BodyStates>("/rigid_body_node/states", 10, receive);
  while (ros::ok() && received == 0) serve(0.01);
  const ros::WallTime first = ros::WallTime::now();
  received = 0;
  while (ros::ok() && ros::WallTime::now() < first + ros::WallDuration(seconds)) serve(0.1);
  std::printf("%.3f %.1f\n", first.toSec(), received / seconds);
  return 0;
}
