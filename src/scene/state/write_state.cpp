#include <array>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>

#include "scene/files/percent_code.hpp"
#include "scene/state/state_format.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity();

/// YAML, every number in the digits that keep its bits.
class Writer {
 public:
  explicit Writer(const World& world) : world_(world) {
    out_.imbue(std::locale::classic());
    out_.precision(std::numeric_limits<double>::max_digits10);
    out_ << std::boolalpha;
  }

  void write(const State& state);
  std::string text() const { return out_.str(); }

 private:
  Writer& operator<<(const char* text) { return out_ << text, *this; }
  Writer& operator<<(const std::string& text) { return out_ << text, *this; }
  Writer& operator<<(bool truth) { return out_ << truth, *this; }
  Writer& operator<<(int count) { return out_ << count, *this; }
  Writer& operator<<(std::int64_t count) { return out_ << count, *this; }
  Writer& operator<<(double x) {
    if (std::isinf(x)) return *this << (x > 0 ? ".inf" : "-.inf");
    return out_ << x, *this;
  }
  Writer& operator<<(const Vector3d& v) {
    return *this << "[" << v.x() << ", " << v.y() << ", " << v.z() << "]";
  }
  template <class Items, class Write>
  void writeList(const Items& items, const Write& write) {
    *this << "[";
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (i > 0) *this << ", ";
      write(items[i]);
    }
    *this << "]";
  }

  void writeHead(const State& state);
  void write(const BodyState& state, const char* separator);
  void write(const MassProperties& changed);
  void writeBody(const State& state, std::size_t body);
  void write(const std::string& actuator, const ActuatorState& state);
  void write(const ScheduledWrench& entry);
  void write(const ActuatorCommand& command);
  void write(const MotionPlan& plan);

  const World& world_;
  std::ostringstream out_;
};

void Writer::writeHead(const State& state) {
  const SolverOptions& solver = world_.solver;
  *this << "# A state of a run of rigid_body_sim: simulate SCENE --load FILE goes on from it.\n"
        << "version: " << kStateVersion << "\n";
  *this << "scene: \"" << world_.fingerprint << "\"\n"
        << "solver: {integrator: " << solver.integrator << ", time_step: " << solver.time_step
        << ", tolerance: " << solver.tolerance << ", horizon: " << solver.horizon
        << ", tolerance_stated: " << solver.tolerance_stated << "}\n";
  *this << "time: " << state.t << "\n";
}

void Writer::write(const BodyState& s, const char* separator) {
  const Quaterniond& q = s.q_WP;
  *this << "position: " << s.x_W << separator << "position_low: " << s.x_low_W << separator;
  *this << "attitude: [" << q.x() << ", " << q.y() << ", " << q.z() << ", " << q.w() << "]"
        << separator;
  *this << "momentum: " << s.p_W << separator << "angular_momentum_world: " << s.L_W << separator
        << "angular_momentum_body: " << s.L_P;
}

void Writer::write(const std::string& actuator, const ActuatorState& s) {
  *this << "      - {name: " << actuator << ", command: " << s.command << ", value: " << s.value;
  *this << ", since: " << s.since << ", until: " << s.until << ", saturations: " << s.saturations
        << "}\n";
}

void Writer::write(const ScheduledWrench& entry) {
  const PointWrench& wrench = entry.wrench;
  *this << "      - {slot: \"" << percentEncoded(entry.slot) << "\"";
  // left out: the world
  if (wrench.axes < world_.bodies.size()) *this << ", axes: " << world_.bodies[wrench.axes].name;
  if (wrench.point_frame < world_.bodies.size())
    *this << ", point_frame: " << world_.bodies[wrench.point_frame].name;
  *this << ", force: " << wrench.force << ", torque: " << wrench.torque
        << ", point: " << wrench.point;
  if (wrench.at_center) *this << ", at_center_of_mass: true";
  *this << ", start: " << wrench.start << ", end: " << wrench.end << "}\n";
}

void Writer::write(const ActuatorCommand& command) {
  *this << "      - {actuator: " << world_.bodies[command.body].actuators[command.actuator].name
        << ", value: " << command.value << ", start: " << command.start << ", end: " << command.end
        << "}\n";
}

void Writer::write(const MassProperties& changed) {
  const Matrix3d& I = changed.I_Bcm;
  *this << "    mass_properties: {mass: " << changed.mass << ", center_of_mass: " << changed.com_B
        << ", inertia: ";
  writeList(std::array{I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)},
            [this](double entry) { *this << entry; });
  *this << "}\n";
}

void Writer::writeBody(const State& state, std::size_t i) {
  const Body& body = world_.bodies[i];
  *this << "  - name: " << body.name << "\n";
  if (i < state.changes.size() && state.changes[i].absent)
    *this << "    absent: " << *state.changes[i].absent << "\n";
  if (i < state.changes.size() && state.changes[i].properties_B)
    write(*state.changes[i].properties_B);
  if (!body.fixed) *this << "    mass: " << body.mass << "\n    moments: " << body.I << "\n";
  *this << "    ";
  write(state.bodies[i], "\n    ");
  *this << "\n";
  if (i < state.anchors.size() && state.anchors[i].horizon > -kInf && moves(body)) {
    const MotionAnchor& anchor = state.anchors[i];
    *this << "    anchor: {time: " << anchor.t << ", horizon: " << anchor.horizon << ", ";
    write(anchor.state, ", ");
    *this << "}\n";
  }
  if (!body.actuators.empty() && i < state.actuators.size()) {
    *this << "    actuators:\n";
    for (std::size_t k = 0; k < body.actuators.size(); ++k)
      write(body.actuators[k].name, state.actuators[i][k]);
  }
  if (i >= state.schedules.size()) return;
  const BodySchedule& schedule = state.schedules[i];
  if (!schedule.wrenches.empty()) *this << "    wrenches:\n";
  for (const ScheduledWrench& entry : schedule.wrenches) write(entry);
  if (!schedule.commands.empty()) *this << "    commands:\n";
  for (const ActuatorCommand& command : schedule.commands) write(command);
}

void Writer::write(const MotionPlan& plan) {
  const auto writeIndex = [this](std::size_t index) { *this << static_cast<std::int64_t>(index); };
  *this << "  - {bodies: ";
  writeList(plan.bodies, [this](std::size_t body) { *this << world_.bodies[body].name; });
  *this << ", laws: ";
  writeList(plan.laws, writeIndex);
  *this << ", waiting_laws: ";
  writeList(plan.waiting_laws, writeIndex);
  if (!plan.integrator.empty()) *this << ", integrator: " << plan.integrator;
  *this << ", substeps: " << plan.substeps << ", by_estimates: " << plan.by_estimates
        << ", at_rest: " << plan.at_rest << ", holds: " << plan.holds;
  *this << ", error: " << plan.error << ", tried_until: " << plan.tried_until
        << ", cut_short: " << plan.cut_short << "}\n";
}

void Writer::write(const State& state) {
  writeHead(state);
  *this << "bodies:\n";
  for (std::size_t i = 0; i < world_.bodies.size(); ++i) writeBody(state, i);
  *this << "laws: ";
  writeList(state.laws, [this](double own) { *this << own; });
  *this << "\ngroups:\n";
  for (const MotionPlan& plan : state.plans) write(plan);
  *this << "near_laws: ";
  writeList(state.near_laws, [this](std::size_t law) { *this << static_cast<std::int64_t>(law); });
  if (state.contact_bound > 0) *this << "\ncontact_bound: " << state.contact_bound;
  *this << "\n" << kLastKey << ": true\n";
}

}  // namespace

std::string writtenState(const World& world, const State& state) {
  Writer writer(world);
  writer.write(state);
  return writer.text();
}

}  // namespace rigid_body_sim
