#include "tools/compare_runs/motion_difference.hpp"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include <rigid_body_sim/math/rotation.hpp>

#include "programs/formatted.hpp"

namespace rigid_body_sim {
namespace {

double distance(const Motion& a, const Motion& b, std::size_t begin) {
  return Vector3d(a[begin] - b[begin], a[begin + 1] - b[begin + 1], a[begin + 2] - b[begin + 2])
      .norm();
}

Quaterniond attitudeOf(const Motion& m) { return Quaterniond(m[6], m[3], m[4], m[5]); }

void compare(std::int64_t time, const Motion& a, const Motion& b, MotionDifference& worst) {
  ++worst.instants;
  if (std::memcmp(a.data(), b.data(), sizeof a) == 0) return;  // 0 and -0 are other bits
  if (worst.same_bits) worst.first = time;
  worst.same_bits = false;
  const auto raise = [](double& greatest, double x) { greatest = std::max(greatest, x); };
  raise(worst.position, distance(a, b, 0));
  raise(worst.attitude, angleBetween(attitudeOf(a), attitudeOf(b)));
  raise(worst.velocity, distance(a, b, 7));
  raise(worst.angular_velocity, distance(a, b, 10));
}

std::string timeText(std::int64_t time) {
  const std::lldiv_t seconds = std::lldiv(time, 1000000000);
  return formatted("%lld.%09lld", seconds.quot, std::abs(seconds.rem));
}

std::string spanText(const std::map<std::int64_t, Motion>& motion) {
  return timeText(motion.begin()->first) + " to " + timeText(motion.rbegin()->first) + " s";
}

std::string namesOf(const RecordedMotion& motion) {
  std::string names;
  for (const auto& body : motion) names += (names.empty() ? "'" : ", '") + body.first + "'";
  return names.empty() ? "none" : names;
}

MotionDifference differenceOf(const std::string& body, const std::map<std::int64_t, Motion>& a,
                              const std::map<std::int64_t, Motion>& b) {
  MotionDifference difference;
  difference.body = body;
  for (const auto& [time, motion] : a) {
    const auto other = b.find(time);
    if (other != b.end()) compare(time, motion, other->second, difference);
  }
  difference.alone = a.size() + b.size() - 2 * difference.instants;
  if (difference.instants == 0)
    throw std::runtime_error("body '" + body + "': no instant in common: the first run holds " +
                             spanText(a) + ", the second " + spanText(b));
  return difference;
}

}  // namespace

bool MotionDifference::isWithin(double tolerance) const {
  // without a tolerance even differences too small for their norm count
  return same_bits ||
         (tolerance > 0 && std::max({position, attitude, velocity, angular_velocity}) <= tolerance);
}

std::vector<MotionDifference> differencesOf(const RecordedMotion& a, const RecordedMotion& b) {
  std::vector<MotionDifference> differences;
  for (const auto& [body, motion] : a)
    if (const auto other = b.find(body); other != b.end())
      differences.push_back(differenceOf(body, motion, other->second));
  if (differences.empty())
    throw std::runtime_error("no body in common: the first run holds " + namesOf(a) +
                             ", the second " + namesOf(b));
  return differences;
}

std::vector<std::string> bodiesOfOne(const RecordedMotion& a, const RecordedMotion& b) {
  std::vector<std::string> names;
  for (const auto& [first, second] : {std::pair(&a, &b), std::pair(&b, &a)})
    for (const auto& body : *first)
      if (second->count(body.first) == 0) names.push_back(body.first);
  return names;
}

std::string text(const MotionDifference& d) {
  std::string line =
      formatted("%s: %zu instants in both, %zu in one only: ", d.body.c_str(), d.instants, d.alone);
  if (d.same_bits) return line + "the same bits\n";
  line += formatted("position %.2g m, attitude %.2g rad, velocity %.2g m/s, ", d.position,
                    d.attitude, d.velocity);
  return line + formatted("angular velocity %.2g rad/s; first at %s s\n", d.angular_velocity,
                          timeText(d.first).c_str());
}

}  // namespace rigid_body_sim
