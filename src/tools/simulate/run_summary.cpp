#include "tools/simulate/run_summary.hpp"

#include <algorithm>
#include <cstdio>

#include "programs/formatted.hpp"

namespace rigid_body_sim {
namespace {

std::string text(const Vector3d& v) { return formatted("(%.4g, %.4g, %.4g)", v.x(), v.y(), v.z()); }

double ratio(double difference, double scale) { return difference == 0 ? 0 : difference / scale; }

/// By a wrench, by drag or by a law of force.
bool isActedOn(const World& world, std::size_t body, double t_end) {
  const auto acts_on_it = [body](const auto& law) {
    const std::vector<std::size_t> members = law->members();
    return std::find(members.begin(), members.end(), body) != members.end();
  };
  return std::any_of(world.laws.begin(), world.laws.end(), acts_on_it) ||
         std::any_of(world.wrenches.begin(), world.wrenches.end(), [=](const PointWrench& wrench) {
           return wrench.body == body && wrench.start < t_end;
         });
}

/// What a body has at one instant.
struct Kept {
  Kept(const Body& body, const BodyState& state, const Vector3d& g_W)
      : kinetic(kineticEnergy(body, state)),
        energy(kinetic - body.mass * g_W.dot(state.x_W + state.x_low_W)),
        momentum(state.p_W),
        angular_momentum(state.L_W) {}
  double kinetic;             // [J]
  double energy;              // [J]
  Vector3d momentum;          // [kg m/s]
  Vector3d angular_momentum;  // [kg m²/s] about the centre of mass
};

std::string keptText(const Kept& a, const Kept& b, const Vector3d& weight_impulse) {
  const double energy_scale = std::max(a.kinetic, b.kinetic);
  const double p_scale = std::max(a.momentum.norm(), b.momentum.norm());
  const double L_scale = a.angular_momentum.norm();
  return formatted("  kept: energy %.4g J to %.1e, momentum to %.1e, angular momentum to %.1e\n",
                   b.energy, ratio(std::abs(b.energy - a.energy), energy_scale),
                   ratio((b.momentum - a.momentum - weight_impulse).norm(), p_scale),
                   ratio((b.angular_momentum - a.angular_momentum).norm(), L_scale));
}

std::string pushedText(const Kept& a, const Kept& b, const Vector3d& weight_impulse) {
  return formatted("  pushed: energy %+.4g J, momentum ", b.energy - a.energy) +
         text(b.momentum - a.momentum - weight_impulse) + " N s, angular momentum " +
         text(b.angular_momentum - a.angular_momentum) + " N m s\n";
}

}  // namespace

std::string runSummary(const World& world, const State& first, const State& last) {
  std::string summary;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Body& body = world.bodies[i];
    if (body.fixed) continue;
    const BodyFrameMotion m = toBodyFrameMotion(body, last.bodies[i]);
    summary += body.name + ": from " + text(toBodyFrameMotion(body, first.bodies[i]).x_W) + " to " +
               text(m.x_W) + " m, velocity " + text(m.v_W) + " m/s, turning at " + text(m.w_W) +
               " rad/s\n";
    const Kept a(body, first.bodies[i], world.g_W);
    const Kept b(body, last.bodies[i], world.g_W);
    const Vector3d weight_impulse = body.mass * (last.t - first.t) * world.g_W;
    summary += isActedOn(world, i, last.t) ? pushedText(a, b, weight_impulse)
                                           : keptText(a, b, weight_impulse);
  }
  if (!world.laws.empty()) {
    const double energy = mechanicalEnergy(world, last);
    summary += formatted("all together: energy %.4g J, %+.2g J since the start\n", energy,
                         energy - mechanicalEnergy(world, first));
  }
  return summary;
}

}  // namespace rigid_body_sim
