#include "tools/compare_runs/motion_difference.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include <rigid_body_sim/math/rotation.hpp>

#include "programs/formatted.hpp"

namespace rigid_body_sim {
namespace {

double distance(const Motion& a, const Motion& b, std::size_t begin) {
  return std::hypot(a[begin] - b[begin], a[begin + 1] - b[begin + 1], a[begin + 2] - b[begin + 2]);
}

Quaterniond attitudeOf(const Motion& m) { return Quaterniond(m[6], m[3], m[4], m[5]); }

/// How far two motions at one instant are apart.
MotionDifference between(const Motion& a, const Motion& b) {
  MotionDifference d;
  d.same_bits = haveSameBits(a, b);
  if (d.same_bits) return d;
  d.position = distance(a, b, 0);
  d.attitude = angleBetween(attitudeOf(a), attitudeOf(b));
  d.velocity = distance(a, b, 7);
  d.angular_velocity = distance(a, b, 10);
  return d;
}

double greatest(const MotionDifference& d) {
  return std::max({d.position, d.attitude, d.velocity, d.angular_velocity});
}

bool isNearer(const MotionDifference& a, const MotionDifference& b) {
  return a.same_bits || (!b.same_bits && greatest(a) < greatest(b));
}

MotionDifference leastBetween(const std::vector<Motion>& a, const std::vector<Motion>& b) {
  MotionDifference least = between(a.back(), b.back());
  for (const Motion& one : a)
    for (const Motion& other : b)
      if (const MotionDifference d = between(one, other); isNearer(d, least)) least = d;
  return least;
}

void compare(std::int64_t time, const std::vector<Motion>& a, const std::vector<Motion>& b,
             MotionDifference& worst) {
  ++worst.instants;
  if (a.size() > 1 || b.size() > 1) ++worst.several;
  const MotionDifference here = leastBetween(a, b);
  if (here.same_bits) return;
  if (worst.same_bits) worst.first = time;
  worst.same_bits = false;
  const auto raise = [](double& highest, double x) { highest = std::max(highest, x); };
  raise(worst.position, here.position);
  raise(worst.attitude, here.attitude);
  raise(worst.velocity, here.velocity);
  raise(worst.angular_velocity, here.angular_velocity);
}

std::string timeText(std::int64_t time) {
  const std::lldiv_t seconds = std::lldiv(time, 1000000000);
  return formatted("%lld.%09lld", seconds.quot, std::abs(seconds.rem));
}

std::string spanText(const Motions& motion) {
  return timeText(motion.begin()->first) + " to " + timeText(motion.rbegin()->first) + " s";
}

std::string namesOf(const RecordedMotion& motion) {
  std::string names;
  for (const auto& body : motion.bodies) names += (names.empty() ? "'" : ", '") + body.first + "'";
  return names.empty() ? "none" : names;
}

MotionDifference differenceOf(const std::string& body, const Motions& a, const Motions& b) {
  MotionDifference difference;
  difference.body = body;
  for (const auto& [time, motions] : a) {
    const auto other = b.find(time);
    if (other != b.end()) compare(time, motions, other->second, difference);
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
  return same_bits || (tolerance > 0 && greatest(*this) <= tolerance);
}

bool MotionDifference::isOfBitsAlone() const { return !same_bits && greatest(*this) == 0; }

std::vector<MotionDifference> differencesOf(const RecordedMotion& a, const RecordedMotion& b) {
  std::vector<MotionDifference> differences;
  for (const auto& [body, motion] : a.bodies)
    if (const auto other = b.bodies.find(body); other != b.bodies.end())
      differences.push_back(differenceOf(body, motion, other->second));
  if (differences.empty())
    throw std::runtime_error("no body in common: the first run holds " + namesOf(a) +
                             ", the second " + namesOf(b));
  return differences;
}

std::vector<std::string> bodiesOfOne(const RecordedMotion& a, const RecordedMotion& b) {
  std::vector<std::string> names;
  for (const auto& [first, second] :
       {std::pair(&a.bodies, &b.bodies), std::pair(&b.bodies, &a.bodies)})
    for (const auto& body : *first)
      if (second->count(body.first) == 0) names.push_back(body.first);
  return names;
}

std::string text(const MotionDifference& d) {
  std::string line =
      formatted("%s: %zu instants in both, %zu in one only: ", d.body.c_str(), d.instants, d.alone);
  if (d.several > 0)
    line = formatted(
        "%s: %zu instants in both (at %zu of them a run holds several states, of which the nearest "
        "counts), %zu in one only: ",
        d.body.c_str(), d.instants, d.several, d.alone);
  if (d.same_bits) return line + "the same bits\n";
  if (d.isOfBitsAlone())
    return line +
           formatted(
               "only bits differ, as those of 0 and -0 or of q and -q, the same attitude; first "
               "at %s s\n",
               timeText(d.first).c_str());
  line += formatted("position %.2g m, attitude %.2g rad, velocity %.2g m/s, ", d.position,
                    d.attitude, d.velocity);
  return line + formatted("angular velocity %.2g rad/s; first at %s s\n", d.angular_velocity,
                          timeText(d.first).c_str());
}

}  // namespace rigid_body_sim
