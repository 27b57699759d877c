#include "scene/readers/suspicious.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "math/wide.hpp"

namespace rigid_body_sim {
namespace {

void note(const std::string& text, RepeatedNotice& notice) {
  if (notice.count++ == 0) notice.first = text;
}

/// A full turn a second, in degrees, is beyond it.
bool isFast(const Vector3d& w) { return w.norm() > 50 * 2 * kPi<double>; }

/// What small rotations become when w stands first: a turn of more than a right angle about x.
bool looksLikeWFirst(const Quaterniond& q) { return q.x() * q.x() > 0.51; }

}  // namespace

void noteSuspicious(const Entry& entry, const BodyDef& body) {
  const YamlNode* orientation = entry.node().find("orientation");
  const bool is_quaternion = orientation && orientation->kind() == YamlNode::Kind::kList;
  const bool is_fast = isFast(body.twist.angular);
  const bool is_flipped = is_quaternion && looksLikeWFirst(body.orientation);
  if (!is_fast && !is_flipped) return;
  std::ostringstream text;
  text.precision(3);
  if (is_fast) {
    text << "twist.angular is "
         << body.twist.angular.norm() / (2 * kPi<double>) << " turns/s; its unit is rad/s";
    const Entry twist = entry.child(*entry.node().find("twist"));
    note(twist.located(text.str()), entry.context().fast_spin);
  }
  if (is_flipped) {
    const double z = (body.orientation * Vector3d::UnitZ()).z();
    const double tilt = std::acos(std::clamp(z, -1.0, 1.0));
    text.str("");
    text << "orientation turns the z axis by "
         << tilt * 180 / kPi<double> << " degrees; quaternions are [x, y, z, w]";
    note(entry.child(*orientation).located(text.str()), entry.context().flipped);
  }
}

std::vector<std::string> suspicions(const ReadContext& context) {
  std::vector<std::string> notices;
  for (const RepeatedNotice& notice : {context.fast_spin, context.flipped}) {
    if (notice.count == 0) continue;
    const std::size_t others = notice.count - 1;
    notices.push_back(notice.first +
                      (others == 0 ? "" : " (and " + std::to_string(others) + " more)"));
  }
  return notices;
}

}  // namespace rigid_body_sim
