#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <vector>

#include <geometry_msgs/WrenchStamped.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>
#include <rosbag/message_instance.h>

#include <rigid_body_sim/Contacts.h>
#include <rigid_body_sim/SimStatus.h>

#include "ros/bag/in_file_order.hpp"
#include "ros/bag/open_bag.hpp"
#include "ros/bag/run_starts.hpp"
#include "ros/messages/conversions.hpp"
#include "scene/message_text.hpp"
#include "tools/common/require_motion.hpp"
#include "tools/plot/run_data.hpp"

namespace rigid_body_sim {
namespace {

template <std::size_t N>
void requireFinite(const std::array<double, N>& row) {
  for (const double x : row)
    if (!std::isfinite(x)) throw std::runtime_error("a number is not finite");
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

std::array<double, 3> numbersOf(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

/// Odometry gives velocities in the axes of the body.
std::array<double, 13> motionOf(const nav_msgs::Odometry& message) {
  const auto& [x, q] = message.pose.pose;
  const Quaterniond q_WB(q.w, q.x, q.y, q.z);
  const Vector3d v = q_WB * fromVector3(message.twist.twist.linear);
  const Vector3d w = q_WB * fromVector3(message.twist.twist.angular);
  return {x.x, x.y, x.z, q.x, q.y, q.z, q.w, v.x(), v.y(), v.z(), w.x(), w.y(), w.z()};
}

// why there is no picture of energy and momentum
constexpr const char* kNoStatus =
    ": energy and momentum are not drawn, for it holds no status (rigid_body_sim/SimStatus): "
    "record ~status of the node, too, or draw the run with simulate --plot";
constexpr const char* kNoBalance =
    ": energy and momentum are not drawn, for no status in it has a balance yet: record ~status "
    "for more than two seconds";

constexpr const char* kRuns =
    ": holds several runs, separated by resets or loads, of which the last is drawn";

/// Reads message after message of a bag, and keeps its last run.
class BagRunReader {
 public:
  void take(const rosbag::MessageInstance& message) {
    takeAs<nav_msgs::Odometry>(message, &BagRunReader::takeOdometry);
    takeAs<SimStatus>(message, &BagRunReader::takeStatus);
    takeAs<Contacts>(message, &BagRunReader::takeContacts);
    if (endsWith(message.getTopic(), "/applied_wrench"))
      takeAs<geometry_msgs::WrenchStamped>(message, &BagRunReader::takeApplied);
    if (endsWith(message.getTopic(), "/pivot_force"))
      takeAs<geometry_msgs::WrenchStamped>(message, &BagRunReader::takePivot);
  }

  /// The run as it has been read, with what there is to say of it.
  RunData run(const std::string& path) const {
    RunData run = run_;
    if (run.motion.empty())
      throw std::runtime_error(std::string("holds no odometry (nav_msgs/Odometry)") +
                               (starts_.runs() > 1 ? " of the last of its runs" : "") +
                               ": record <body>/odom");
    if (starts_.runs() > 1) run.notices.push_back(oneLine(path) + kRuns);
    if (run.balance.t.empty())
      run.notices.push_back(oneLine(path) + (has_status_ ? kNoBalance : kNoStatus));
    return run;
  }

 private:
  template <class Message>
  void takeAs(const rosbag::MessageInstance& instance, void (BagRunReader::*keep)(const Message&)) {
    const auto message = instance.instantiate<Message>();
    if (!message) return;
    if (starts_.isStart(instance.getTopic(), message->header.stamp)) {
      run_ = {};
      begin_.reset();
      contact_times_.clear();
    }
    (this->*keep)(*message);
  }

  /// [s] From the first stamp on, where stamps are wall time: more digits than a plot can show.
  double timeOf(const ros::Time& stamp) {
    constexpr double kWallTime = 1e6;  // [s] beyond which no simulation is plotted as a whole
    if (!begin_) begin_ = stamp.toSec() > kWallTime ? stamp : ros::Time();
    run_.begin = begin_->toSec();
    return toSeconds(stamp - *begin_);
  }

  template <std::size_t N>
  void add(const std::string& body, const ros::Time& stamp, const std::array<double, N>& row,
           ByBody<N>& all) {
    requireFinite(row);
    Samples<N>& samples = all.of(body);
    samples.t.push_back(timeOf(stamp));
    samples.rows.push_back(row);
  }

  void takeOdometry(const nav_msgs::Odometry& message) {
    const std::array<double, 13> motion = motionOf(message);
    requireMotion(motion);
    add(message.child_frame_id, message.header.stamp, motion, run_.motion);
  }

  void takeApplied(const geometry_msgs::WrenchStamped& message) {
    const auto& [f, tau] = message.wrench;
    add<6>(message.header.frame_id, message.header.stamp, {f.x, f.y, f.z, tau.x, tau.y, tau.z},
           run_.applied);
  }

  void takePivot(const geometry_msgs::WrenchStamped& message) {
    const auto& f = message.wrench.force;
    if (f.x == 0 && f.y == 0 && f.z == 0) return;  // of a body without a pivot
    add<3>(message.header.frame_id, message.header.stamp, {f.x, f.y, f.z}, run_.pivot);
  }

  /// The sum of the contacts of each body that touches anything in the bag: zero before.
  void takeContacts(const Contacts& message) {
    std::map<std::string, Vector3d> forces;
    for (const BodySamples<3>& known : run_.contact.all()) forces[known.body] = Vector3d::Zero();
    for (const ContactState& contact : message.contacts) {
      const Vector3d force =
          fromVector3(contact.normal_force) + fromVector3(contact.friction_force);
      addTo(contact.body, force, forces);
      addTo(contact.other, -force, forces);
    }
    for (const auto& [body, force] : forces) {
      Samples<3>& samples = run_.contact.of(body);
      if (samples.t.empty()) samples = {contact_times_, {contact_times_.size(), {0, 0, 0}}};
      add(body, message.header.stamp, numbersOf(force), run_.contact);
    }
    contact_times_.push_back(timeOf(message.header.stamp));
  }

  static void addTo(const std::string& body, const Vector3d& force,
                    std::map<std::string, Vector3d>& forces) {
    if (body.empty()) return;  // the world
    const auto known = forces.emplace(body, Vector3d::Zero()).first;
    known->second += force;
  }

  /// Balances that nobody has subscribed to yet are not numbers.
  void takeStatus(const SimStatus& status) {
    has_status_ = true;
    const Vector3d p = fromVector3(status.momentum), L = fromVector3(status.angular_momentum);
    const Vector3d dp = fromVector3(status.momentum_balance);
    const Vector3d dL = fromVector3(status.angular_momentum_balance);
    const std::array<double, 16> row{
        status.mechanical_energy, 0,      status.work, p.x(),  p.y(),  p.z(),  L.x(), L.y(), L.z(),
        status.energy_balance,    dp.x(), dp.y(),      dp.z(), dL.x(), dL.y(), dL.z()};
    if (!std::all_of(row.begin(), row.end(), [](double x) { return std::isfinite(x); })) return;
    run_.balance.t.push_back(timeOf(status.header.stamp));
    run_.balance.rows.push_back(row);
  }

  RunStarts starts_;
  RunData run_;
  bool has_status_ = false;
  std::optional<ros::Time> begin_;
  std::vector<double> contact_times_;  // [s] of all messages
};

}  // namespace

RunData readBagRun(const std::string& path) {
  rosbag::Bag bag;
  openBag(path, bag);
  BagRunReader reader;
  inFileOrder(bag, [&reader](const rosbag::MessageInstance& message) {
    try {
      reader.take(message);
    } catch (const std::exception& fault) {
      throw std::runtime_error(message.getTopic() + ": " + fault.what());
    }
  });
  return reader.run(path);
}

}  // namespace rigid_body_sim
