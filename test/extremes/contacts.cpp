#include <cmath>
#include <stdexcept>

#include "sections.hpp"
#include "setting_text.hpp"
#include "support/contact_benches.hpp"

/// Bodies that touch the ground. Every cell comes to its end: by itself, by a message, or by the
/// work that it may take.
namespace rigid_body_sim::extremes {
namespace {

using test::Bench;
using test::contactOf;
using test::motionAt;

constexpr double kGravity = 9.80665;  // [m/s²]
constexpr double kRadius = 0.1;       // [m]
constexpr double kMaxEvaluations = 2e7;

/// A ball that bounces without loss on a linear spring.
struct Bounce {
  double stiffness = 1e6, mass = 1;  // [N/m], [kg]
  double drop = 0.5, speed = 0;      // [m] above the ground, [m/s] downwards

  double impact() const { return std::sqrt(speed * speed + 2 * kGravity * drop); }
  double fall() const { return 2 * drop / (speed + impact()); }
  double rate() const { return std::sqrt(stiffness / mass); }
  /// [m] How far its height may be from the ground.
  double swing() const {
    const double v = impact(), g = kGravity, w = rate();
    return v * v / (2 * g) + g / (w * w) + std::sqrt(g * g / (w * w) + v * v) / w;
  }

  /// [m] Of its lowest point: a parabola, and while it touches the swing about its depth at rest
  ///   δ = g/ω² (1 − cos ωτ) + v/ω sin ωτ.
  double height(double t) const {
    const double v = impact(), w = rate(), rest = kGravity / (w * w), flight = 2 * v / kGravity;
    const double touching = 2 * (M_PI - std::atan2(v / w, rest)) / w;
    if (t < fall()) return drop - speed * t - kGravity * t * t / 2;
    const double since = std::fmod(t - fall(), touching + flight);
    if (since > touching) {
      const double tau = since - touching;
      return v * tau - kGravity * tau * tau / 2;
    }
    const double half = std::sin(w * since / 2);
    return -(2 * rest * half * half + v / w * std::sin(w * since));
  }

  Bench bench() const {
    Bench bench;
    bench.world.g_W = {0, 0, -kGravity};
    test::addBall(bench, kRadius, mass, motionAt({0, 0, kRadius + drop}, {0, 0, -speed}),
                  test::slope(0), contactOf(stiffness, 1, 0, 0));
    return bench;
  }
};

/// As a scene that states a tolerance, over the run.
void state(double tolerance, double duration, World& world) {
  world.solver.tolerance = tolerance;
  world.solver.tolerance_stated = true;
  world.solver.horizon = duration;
}

/// Steps to the end, the start and each step shown to `look`; fills in what stopped it.
template <class Look>
void run(const Bench& bench, const Run& steps, Cell& cell, const Look& look) {
  try {
    Simulation simulation = bench.simulation("auto", steps.time_step);
    look(simulation);
    for (int i = 0; i < steps.steps && cell.said.empty(); ++i) {
      simulation.step();
      look(simulation);
      if (static_cast<double>(simulation.evaluations()) > kMaxEvaluations)
        cell.said = "not at its end after 2e7 evaluations";
    }
  } catch (const std::runtime_error& stopped) {
    cell.said = stopped.what();
  } catch (const std::invalid_argument& refused) {
    cell.said = refused.what();
  }
}

/// Over three bounces: place against the closed form, and energy, relative to how far the ball goes
/// and to what it gains by that way.
Cell bounced(const std::string& section, double setting, const Bounce& bounce) {
  Cell cell{section, settingText(setting), "auto"};
  const double period = 2 * bounce.impact() / kGravity + M_PI / bounce.rate();
  const Run steps{period / 100, 300};
  Bench bench = bounce.bench();
  state(1e-9, steps.duration(), bench.world);
  const double start = kGravity * bounce.drop + bounce.speed * bounce.speed / 2;  // [J/kg]
  run(bench, steps, cell, [&](const Simulation& simulation) {
    const BodyState now = simulation.body(0);
    const double height = now.x_W.z() - kRadius + now.x_low_W.z(), v = now.p_W.z() / bounce.mass;
    const double below = bounce.rate() * std::min(height, 0.0);
    const double error = std::abs(height - bounce.height(simulation.time()));
    const double gain = std::abs(kGravity * height + (v * v + below * below) / 2 - start);
    cell.position = std::max(cell.position, error / bounce.swing());
    cell.energy = std::max(cell.energy, gain / (kGravity * bounce.swing()));
  });
  return cell;
}

/// A box of 0.4 × 0.3 × 0.2 m and 5 kg.
Bench boxOn(const BodyFrameMotion& motion, double friction) {
  Bench bench;
  bench.world.g_W = {0, 0, -kGravity};
  test::addBox(bench, {0.4, 0.3, 0.2}, 5, motion, test::slope(0),
               contactOf(1e6, 1.5, 0.2, friction));
  return bench;
}

BodyFrameMotion tumblingAt(double height) {
  BodyFrameMotion motion = motionAt({0, 0, height}, {0.5, 0, 0}, {1, 2, 0.5});
  motion.q_WB = rotationExp(Vector3d(0.3, 0.5, 0.1));
  return motion;
}

/// Steps of 5 ms at a tolerance, beside the run at a tenth of it: attitude and place [m] of the
/// first body; the greatest rise of the energy within a step.
Cell landed(Cell cell, Bench bench, double tolerance, int count) {
  const Run steps{5e-3, count};
  state(tolerance, steps.duration(), bench.world);
  Bench fine = bench;
  state(tolerance / 10, steps.duration(), fine.world);
  std::vector<BodyState> truth;
  Cell of_truth = cell;
  run(fine, steps, of_truth, [&](const Simulation& s) { truth.push_back(s.body(0)); });
  double start = 0, last = 0;
  std::size_t k = 0;
  run(bench, steps, cell, [&](const Simulation& simulation) {
    const BodyState now = simulation.body(0);
    const double energy = mechanicalEnergy(simulation.world(), simulation.state());
    if (k < truth.size()) {
      cell.attitude = std::max<double>(cell.attitude, angleBetween(now.q_WP, truth[k].q_WP));
      cell.position = std::max(cell.position, distanceBetween(now, truth[k]));
    }
    if (k == 0) start = last = energy;
    cell.energy = std::max(cell.energy, (energy - last) / start);
    last = energy;
    ++k;
  });
  return cell;
}

/// One number of the bounce at each of the values.
Cells bouncedAt(const std::string& section, double Bounce::*number,
                const std::vector<double>& values) {
  Cells cells;
  for (const double value : values) {
    Bounce bounce;
    bounce.*number = value;
    cells.push_back(bounced(section, value, bounce));
  }
  return cells;
}

}  // namespace

Cells contactStiffnesses() {
  return bouncedAt("contact_stiffness", &Bounce::stiffness, {1e2, 1e4, 1e6, 1e8, 1e10});
}

Cells contactMasses() {
  return bouncedAt("contact_mass", &Bounce::mass, {1e-6, 1e-3, 1, 1e3, 1e6});
}

Cells contactSpeeds() { return bouncedAt("contact_speed", &Bounce::speed, {1, 10, 100, 1e3, 1e4}); }

Cells contactDrops() {
  return bouncedAt("contact_drop", &Bounce::drop, {1e-12, 1e-9, 1e-6, 1e-3, 1, 1e3});
}

Cells contactFrictions() {
  Cells cells;
  for (const double friction : {0.0, 1e-3, 0.1, 1.0, 3.0, 10.0})
    cells.push_back(landed({"contact_friction", settingText(friction), "auto"},
                           boxOn(tumblingAt(0.3), friction), 1e-9, 100));
  return cells;
}

Cells contactStarts(int steps) {
  const Vector3d size(0.4, 0.3, 0.2);
  const auto tiltedOn = [&](const Vector3d& down) {
    BodyFrameMotion motion = motionAt({0, 0, 0.5 * down.norm()});
    motion.q_WB = Quaterniond::FromTwoVectors(down, Vector3d::UnitZ());
    return motion;
  };
  const std::vector<std::pair<std::string, BodyFrameMotion>> starts{
      {"just touching", motionAt({0, 0, size.z() / 2})},
      {"on an edge", tiltedOn({0, size.y(), size.z()})},
      {"on a corner", tiltedOn(size)},
      {"1e-15 m deep", motionAt({0, 0, size.z() / 2 - 1e-15})},
      {"1e-9 m deep", motionAt({0, 0, size.z() / 2 - 1e-9})},
      {"1e-3 m deep", motionAt({0, 0, size.z() / 2 - 1e-3})},
      {"a corner 0.2 m deep", tumblingAt(0)},
      {"1 m deep", motionAt({0, 0, -1})},
      {"1e9 m deep", motionAt({0, 0, -1e9})}};
  Cells cells;
  for (const auto& [setting, motion] : starts)
    cells.push_back(landed({"contact_start", setting, "auto"}, boxOn(motion, 0.5), 1e-9, steps));
  return cells;
}

Cells contactCrowds(std::size_t bodies) {
  Bench bench;
  bench.world.g_W = {0, 0, -kGravity};
  for (std::size_t i = 0; i < bodies; ++i) {
    BodyFrameMotion motion = tumblingAt(0.28);
    motion.x_W.x() = static_cast<double>(i);
    motion.w_W *= 1 + 1e-3 * static_cast<double>(i);
    test::addBox(bench, {0.4, 0.3, 0.2}, 5, motion, test::slope(0), contactOf(1e6, 1.5, 0.2, 0.5));
  }
  return {landed({"contact_many", std::to_string(bodies), "auto"}, bench, 1e-6, 100)};
}

}  // namespace rigid_body_sim::extremes
