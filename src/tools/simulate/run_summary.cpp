#include "tools/simulate/run_summary.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/world_changes.hpp"
#include "programs/formatted.hpp"

namespace rigid_body_sim {
namespace {

std::string text(const Vector3d& v) { return formatted("(%.4g, %.4g, %.4g)", v.x(), v.y(), v.z()); }

double ratio(double difference, double scale) { return difference == 0 ? 0 : difference / scale; }

std::string relative(double ratio) { return ratio == 0 ? "0" : formatted("%.1e", ratio); }

using Causes = std::vector<std::string>;

void addOnce(const std::string& cause, Causes& causes) {
  if (std::find(causes.begin(), causes.end(), cause) == causes.end()) causes.push_back(cause);
}

/// What changes energy and momentum of each body beside gravity: wrenches, laws, motors, inputs.
std::vector<Causes> causesOf(const World& world, const State& first, double t_end,
                             const std::vector<InputEffects>& inputs) {
  std::vector<Causes> causes(world.bodies.size());
  const auto add_wrench = [&](const PointWrench& wrench) {
    if (wrench.start < t_end) addOnce("wrenches", causes[wrench.body]);
  };
  for (const BodySchedule& schedule : first.schedules)
    for (const ScheduledWrench& scheduled : schedule.wrenches) add_wrench(scheduled.wrench);
  if (first.schedules.empty())
    for (const PointWrench& wrench : world.wrenches) add_wrench(wrench);
  for (std::size_t i = 0; i < inputs.size(); ++i)
    if (inputs[i].wrench) addOnce("wrenches", causes[i]);
  const auto comes_and_goes = [&](std::size_t body) {
    return body < inputs.size() && inputs[body].presence;
  };
  for (const auto& law : world.laws) {
    const std::vector<std::size_t> members = law->members();
    if (rests(*law, world) && std::none_of(members.begin(), members.end(), comes_and_goes))
      continue;
    for (std::size_t body : members) addOnce(law->name(), causes[body]);
  }
  for (std::size_t i = 0; i < causes.size(); ++i)
    if (world.bodies[i].pivoted) addOnce("pivot", causes[i]);
  for (std::size_t i = 0; i < causes.size(); ++i)
    if (!world.bodies[i].actuators.empty()) addOnce("motors", causes[i]);
  for (std::size_t i = 0; i < inputs.size(); ++i)
    if (inputs[i].mass) addOnce("set_mass_properties", causes[i]);
  for (std::size_t i = 0; i < inputs.size(); ++i)
    if (inputs[i].presence) addOnce("set_present", causes[i]);
  for (std::size_t i = 0; i < inputs.size(); ++i)
    if (inputs[i].mass || inputs[i].presence) addOnce("weight", causes[i]);
  for (std::size_t i = 0; i < inputs.size(); ++i)
    if (inputs[i].moved) addOnce("set_state or reset", causes[i]);
  return causes;
}

/// "wrenches, spring and drag"
std::string joined(const Causes& causes) {
  std::string text = causes.front();
  for (std::size_t i = 1; i < causes.size(); ++i)
    text += (i + 1 < causes.size() ? ", " : " and ") + causes[i];
  return text;
}

/// What a body has at one instant.
struct Conserved {
  Conserved(const Body& body, const BodyState& state, const Vector3d& g_W)
      : kinetic(kineticEnergy(body, state)),
        energy(kinetic - body.mass * g_W.dot(centerOfMass(body, state))),
        momentum(momentumOf(body, state)),
        angular_momentum(state.L_W) {}
  double kinetic;             // [J]
  double energy;              // [J]
  Vector3d momentum;          // [kg m/s]
  Vector3d angular_momentum;  // [kg m²/s] about the centre of mass, or the pivot

  bool isFinite() const {
    return std::isfinite(kinetic) && std::isfinite(energy) && momentum.allFinite() &&
           angular_momentum.allFinite();
  }
};

/// Whether all that a line would say of the change from a to b is a number.
bool areNumbers(const Conserved& a, const Conserved& b, const Vector3d& weight_impulse) {
  return a.isFinite() && b.isFinite() && std::isfinite(b.energy - a.energy) &&
         (b.momentum - a.momentum - weight_impulse).allFinite() &&
         (b.angular_momentum - a.angular_momentum).allFinite();
}

const char* const kTooGreat = "energy and momenta are too great for numbers\n";

std::string conservedText(const Conserved& a, const Conserved& b, const Vector3d& weight_impulse) {
  if (!areNumbers(a, b, weight_impulse))
    return std::string("  whether conserved is not known: ") + kTooGreat;
  const double energy_scale = std::max(a.kinetic, b.kinetic);
  const double p_scale = std::max(stableNorm(a.momentum), stableNorm(b.momentum));
  const double L_scale = stableNorm(a.angular_momentum);
  return formatted("  conserved: energy %.4g J to ", b.energy) +
         relative(ratio(std::abs(b.energy - a.energy), energy_scale)) + ", momentum to " +
         relative(ratio(stableNorm(Vector3d(b.momentum - a.momentum - weight_impulse)), p_scale)) +
         ", angular momentum to " +
         relative(ratio(stableNorm(Vector3d(b.angular_momentum - a.angular_momentum)), L_scale)) +
         "\n";
}

std::string changedText(const Causes& causes, const Conserved& a, const Conserved& b,
                        const Vector3d& weight_impulse) {
  if (!areNumbers(a, b, weight_impulse)) return "  changed by " + joined(causes) + ": " + kTooGreat;
  return "  changed by " + joined(causes) +
         formatted(": energy %+.4g J, momentum ", b.energy - a.energy) +
         text(b.momentum - a.momentum - weight_impulse) + " N s, angular momentum " +
         text(b.angular_momentum - a.angular_momentum) + " N m s\n";
}

}  // namespace

std::string runSummary(const World& world, const State& first, const State& last,
                       const std::vector<InputEffects>& inputs) {
  constexpr std::size_t kMax = 100;  // bodies that anybody would read about one by one
  const std::vector<Causes> causes = causesOf(world, first, last.t, inputs);
  const World world_at_first = withChanges(world, first.changes);
  std::string summary;
  std::size_t moving = 0;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) {
    const Body& body = world.bodies[i];
    const Body& body_at_first = world_at_first.bodies[i];
    if (body.fixed || ++moving > kMax) continue;
    const bool has_come = body_at_first.absent;
    if (body.absent) {
      summary += body.name + (has_come ? ": absent\n" : ": has left\n");
      continue;
    }
    const BodyFrameMotion m = toBodyFrameMotion(body, last.bodies[i]);
    const Vector3d from = toBodyFrameMotion(body_at_first, first.bodies[i]).x_W;
    summary += body.name + (has_come ? ": has come in, at " : ": from " + text(from) + " to ") +
               text(m.x_W) + " m, velocity " + text(m.v_W) + " m/s, turning at " + text(m.w_W) +
               " rad/s\n";
    if (has_come) continue;
    const Conserved a(body_at_first, first.bodies[i], world.g_W);
    const Conserved b(body, last.bodies[i], world.g_W);
    // of a weight that changed meanwhile, the impulse is not known
    const bool same_mass = i >= inputs.size() || !(inputs[i].mass || inputs[i].presence);
    const double mass = same_mass ? body.mass : 0;
    const Vector3d weight_impulse = mass * (last.t - first.t) * world.g_W;
    summary += causes[i].empty() ? conservedText(a, b, weight_impulse)
                                 : changedText(causes[i], a, b, weight_impulse);
  }
  if (moving > kMax)
    summary += formatted("and %zu more bodies, which --csv or --bag writes\n", moving - kMax);
  if (!world.laws.empty()) {
    const double energy = mechanicalEnergy(world, last);
    const double change = energy - mechanicalEnergy(world_at_first, first);
    summary +=
        std::isfinite(change)
            ? formatted("all together: energy %.4g J, %+.2g J since the start\n", energy, change)
            : "all together: the energy is too great for a number\n";
  }
  return summary;
}

}  // namespace rigid_body_sim
