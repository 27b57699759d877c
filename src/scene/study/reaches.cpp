#include "scene/study/reaches.hpp"

#include <cmath>

#include "math/counter_draws.hpp"

namespace rigid_body_sim {
namespace {

/// Numbers in which worlds are compared.
class Features {
 public:
  void add(double x) { numbers_.push_back(x); }
  void add(std::size_t x) { add(static_cast<double>(x)); }
  template <class Derived>
  void add(const Eigen::MatrixBase<Derived>& m) {
    for (Eigen::Index i = 0; i < m.size(); ++i) add(m(i % m.rows(), i / m.rows()));
  }
  void add(const std::string& text) {
    add(text.size());
    for (const char c : text) add(static_cast<double>(c));
  }

  void addActuator(const Actuator& actuator) {
    add(actuator.kind.index());
    add(actuator.least);
    add(actuator.greatest);
    if (const auto* t = std::get_if<Thruster>(&actuator.kind)) {
      add(t->position_B);
      add(t->direction_B);
      add(t->time_constant);
    } else if (const auto* r = std::get_if<Rotor>(&actuator.kind)) {
      add(r->position_B);
      add(r->direction_B);
      for (double x :
           {double(r->turns), r->thrust, r->drag_torque, r->inertia, r->time_constant, r->speed})
        add(x);
    } else {
      const auto& wheel = std::get<Wheel>(actuator.kind);
      add(wheel.axis_B);
      add(wheel.inertia);
      add(wheel.speed);
    }
  }

  void addBody(const Body& body, const BodyState& state) {
    add(std::size_t{body.fixed});
    add(std::size_t{body.absent});
    if (body.absent) return;
    add(state.x_W);
    add(state.q_WP.coeffs());
    if (body.fixed) return;
    add(state.p_W);
    add(state.L_W);
    add(body.mass);
    add(body.I);
    add(body.X_BP.matrix());
    for (const Actuator& actuator : body.actuators) addActuator(actuator);
  }

  void addWrench(const PointWrench& wrench) {
    for (std::size_t index : {wrench.body, wrench.axes, wrench.point_frame}) add(index);
    for (const Vector3d* v : {&wrench.force, &wrench.torque, &wrench.point}) add(*v);
    add(wrench.start);
    add(wrench.end);
  }

  void addCommand(const ActuatorCommand& command) {
    add(command.body);
    add(command.actuator);
    for (double x : {command.value, command.start, command.end}) add(x);
  }

  void addSolver(const SolverOptions& solver) {
    add(solver.integrator);
    add(solver.time_step);
    if (solver.integrator != "auto") return;
    add(std::size_t{solver.tolerance_stated});
    add(solver.tolerance);
    add(solver.horizon);
  }

  /// What the laws do at a state.
  void addLaws(const World& world, const std::vector<BodyState>& states) {
    std::vector<const Body*> bodies;
    for (const Body& body : world.bodies) bodies.push_back(&body);
    std::vector<Wrench> wrenches(bodies.size());
    for (const std::shared_ptr<const ForceLaw>& law : world.laws) {
      std::vector<double> own(law->stateCount());
      law->setStart(own.data());
      const ForceLaw::Bodies at{bodies, states, own.data()};
      law->addWrenches(at, wrenches);
      add(law->potentialEnergy(at));
      add(law->externalPower(at));
    }
    for (const Wrench& wrench : wrenches) {
      add(wrench.f_W);
      add(wrench.tau_W);
      add(wrench.tau_P);
    }
  }

  /// Bit by bit the same; what is no number is so in both.
  bool operator==(const Features& other) const {
    return numbers_.size() == other.numbers_.size() &&
           std::equal(
               numbers_.begin(), numbers_.end(), other.numbers_.begin(),
               [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); });
  }

 private:
  std::vector<double> numbers_;
};

/// States about the initial ones, farther and farther away: the same offsets in both worlds.
std::vector<BodyState> shifted(const World& world, const State& initial, std::uint64_t sample) {
  const auto vector = [&](std::size_t body, std::uint32_t block) {
    Vector3d v;
    for (std::uint32_t i = 0; i < 3; ++i)
      v[i] = 2 * uniformDraws(body, sample, i, block).below_one - 1;
    return v;
  };
  const double scale = std::pow(10.0, static_cast<double>(sample % 6) - 3);
  std::vector<BodyState> states = initial.bodies;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!moves(world.bodies[i])) continue;
    BodyState& s = states[i];
    s.x_W += scale * vector(i, 0);
    s.q_WP = s.q_WP * rotationExp(vector(i, 1));
    s.p_W += world.bodies[i].mass * vector(i, 2);
    s.L_P += world.bodies[i].I.cwiseProduct(vector(i, 3));
    s.L_W = s.q_WP * s.L_P;
  }
  return states;
}

Features featuresOf(const World& world, const State& initial) {
  constexpr std::uint64_t kStates = 60;
  Features features;
  features.add(world.g_W);
  features.addSolver(world.solver);
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
    features.addBody(world.bodies[i], initial.bodies[i]);
  for (const PointWrench& wrench : world.wrenches) features.addWrench(wrench);
  for (const ActuatorCommand& command : world.commands) features.addCommand(command);
  features.addLaws(world, initial.bodies);
  if (world.laws.empty()) return features;
  for (std::uint64_t k = 0; k < kStates; ++k) features.addLaws(world, shifted(world, initial, k));
  return features;
}

}  // namespace

bool differInMotion(const World& a, const State& initial_a, const World& b,
                    const State& initial_b) {
  return !(featuresOf(a, initial_a) == featuresOf(b, initial_b));
}

}  // namespace rigid_body_sim
