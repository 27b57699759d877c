#include "benchmark/touch_peers.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

// Where a body is after it has touched the ground, against processor time: ours and the engines
// found on this machine, each by its own contact. Truth: a rigid body under Coulomb's law, which
// ours comes near by stiffness, the others by short steps. A box that lands has none: there each is
// compared with its own run at its last setting, so that what is shown is whether it converges. Of
// a rattleback, the attitude counts.

namespace rigid_body_sim::touch_peers {

std::vector<TouchEngine>& touchEngines() {
  static std::vector<TouchEngine> all;
  return all;
}

Array3 lowestPoint(const TouchCase& c, const Array3& down_P) {
  const double cos = std::cos(c.shape_turn), sin = std::sin(c.shape_turn);
  const Array3& d = c.semi_axes;
  Array3 along{d[0] * (cos * down_P[0] + sin * down_P[1]),
               d[1] * (cos * down_P[1] - sin * down_P[0]), d[2] * down_P[2]};
  const double length = std::hypot(along[0], along[1], along[2]);
  for (std::size_t i = 0; i < 3; ++i) along[i] *= d[i] / length;
  return {cos * along[0] - sin * along[1], sin * along[0] + cos * along[1], c.shape_up + along[2]};
}

double angleBetween(const Quaternion4& a, const Quaternion4& b) {
  // of the vector part of a⁻¹ b: without loss where they are close
  const Array3 v{a[3] * b[0] - b[3] * a[0] - a[1] * b[2] + a[2] * b[1],
                 a[3] * b[1] - b[3] * a[1] - a[2] * b[0] + a[0] * b[2],
                 a[3] * b[2] - b[3] * a[2] - a[0] * b[1] + a[1] * b[0]};
  const double w = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
  return 2 * std::atan2(std::hypot(v[0], v[1], v[2]), std::abs(w));
}

namespace {

double distance(const Array3& a, const Array3& b) {
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// Dropped from 0.5 m without loss; at the end it falls for the eighth time.
TouchCase bouncingBall() {
  TouchCase c;
  c.name = "ball without loss, 5 s";
  c.radius = 0.1;
  c.x_W = {0, 0, 0.6};
  c.restitution = 1;
  c.duration = 5;
  const double fall = std::sqrt(2 * 0.5 / kGravity), v = kGravity * fall;
  const double since = std::fmod(c.duration + fall, 2 * fall);
  c.has_truth = true;
  c.truth = {0, 0, 0.1 + v * since - kGravity * since * since / 2};
  return c;
}

TouchCase slidingBox() {
  TouchCase c;
  c.name = "box that slides and stops, 0.5 s";
  c.box = {0.4, 0.3, 0.2};
  c.x_W = {0, 0, 0.1};
  c.v_W = {1, 0, 0};
  c.friction = 0.5;
  c.duration = 0.5;
  c.has_truth = true;
  c.truth = {1 / (2 * c.friction * kGravity), 0, 0.1};
  return c;
}

/// It slips until v = Rω, at 5/7 of its speed.
TouchCase rollingBall() {
  TouchCase c;
  c.name = "ball that slides, then rolls, 1 s";
  c.radius = 0.1;
  c.x_W = {0, 0, 0.1};
  c.v_W = {1, 0, 0};
  c.friction = 0.4;
  c.duration = 1;
  const double grip = 2 / (7 * c.friction * kGravity);
  c.has_truth = true;
  c.truth = {grip - c.friction * kGravity * grip * grip / 2 + 5.0 / 7 * (c.duration - grip), 0,
             0.1};
  return c;
}

TouchCase landingBox() {
  TouchCase c;
  c.name = "box that lands on corners, 0.6 s";
  c.box = {0.4, 0.3, 0.2};
  c.x_W = {0, 0, 0.5};
  c.v_W = {0.5, 0, 0};
  c.w_W = {1, 2, 0.5};
  c.rotation = {0.3, 0.5, 0.1};
  c.friction = 0.5;
  c.restitution = 0.5;
  c.duration = 0.6;
  return c;
}

void compare(const TouchCase& c) {
  std::printf("\n%s: error [%s], processor time [ms]%s\n", c.name.c_str(),
              c.isEllipsoid() ? "rad" : "m",
              c.has_truth ? "" : "; error: against the engine's own last run");
  for (const TouchEngine& engine : touchEngines()) {
    std::vector<TouchRun> runs;
    for (const double setting : c.isEllipsoid() ? engine.settings_of_ellipsoids : engine.settings) {
      runs.push_back(engine.run(c, setting));
      if (runs.back().seconds > kPatience) break;
    }
    if (runs.empty()) continue;
    const Array3 truth = c.has_truth ? c.truth : runs.back().x_W;
    std::printf("%-14s", engine.name);
    if (!c.has_truth) runs.pop_back();
    for (const TouchRun& run : runs)
      std::printf(" | %s: %.1e, %.2g", run.setting.c_str(),
                  c.isEllipsoid() ? angleBetween(run.q, c.attitude) : distance(run.x_W, truth),
                  1e3 * run.seconds);
    std::printf("\n");
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace rigid_body_sim::touch_peers

/// Of all cases, or of those whose names begin with the argument.
int main(int argc, char** argv) {
  using namespace rigid_body_sim::touch_peers;
  std::sort(
      touchEngines().begin(), touchEngines().end(),
      [](const TouchEngine& a, const TouchEngine& b) { return std::string(a.name) < b.name; });
  const std::string wanted = argc > 1 ? argv[1] : "";
  for (const TouchCase& c :
       {bouncingBall(), slidingBox(), rollingBall(), landingBox(), rattleback()})
    if (c.name.rfind(wanted, 0) == 0) compare(c);
}
