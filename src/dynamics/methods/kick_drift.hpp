#pragma once

#include <array>

#include "dynamics/methods/catalogue.hpp"
#include "dynamics/rotation/free_motion.hpp"

/// Methods made of kicks (impulses at fixed place and attitude) and drifts (motion without
/// wrenches) in turn. They differ in their coefficients and in how the rotation drifts.
namespace rigid_body_sim::methods {

/// Fractions of the step; kicks and drifts each sum to 1.
template <std::size_t kDrifts>
struct KickDriftKick {
  std::array<double, kDrifts + 1> kicks;
  std::array<double, kDrifts> drifts;
};

template <std::size_t kKicks>
struct DriftKickDrift {
  std::array<double, kKicks + 1> drifts;
  std::array<double, kKicks> kicks;
};

/// The composition of Strang steps of lengths gamma: neighbouring half kicks are one kick.
template <std::size_t kSteps>
constexpr KickDriftKick<kSteps> composition(const std::array<double, kSteps>& gamma) {
  KickDriftKick<kSteps> result{};
  for (std::size_t i = 0; i < kSteps; ++i) {
    result.drifts[i] = gamma[i];
    result.kicks[i] += 0.5 * gamma[i];
    result.kicks[i + 1] += 0.5 * gamma[i];
  }
  return result;
}

/// Impulses of the wrenches over h, and what laws with a flow do meanwhile.
inline void kickAll(const System& system, double h, const std::vector<Wrench>& wrenches,
                    std::vector<BodyState>& bodies) {
  if (system.torque_free) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      BodyState& s = bodies[i];
      s.p_W += h * wrenches[i].f_W;
      s.L_W.array() += h * 0.0;  // for a zero its sign, as where torques are added
      s.L_P.array() += h * 0.0;
    }
    return;
  }
  if (system.flow_of.empty()) {
    for (std::size_t i = 0; i < bodies.size(); ++i)
      kick(wrenches[i].f_W, wrenches[i].tau_W, wrenches[i].tau_P, h, bodies[i]);
    return;
  }
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (const ForceLaw* law = system.flow_of[i])
      law->kick(*system.bodies[i], wrenches[i], h, bodies[i]);
    else
      kick(wrenches[i].f_W, wrenches[i].tau_W, wrenches[i].tau_P, h, bodies[i]);
  }
}

/// The laws' own states over a drift of h, by the mean of their rates at its start and, estimated,
/// at its end: second order.
class LawDrift {
 public:
  LawDrift(const System& system, const SystemState& states) : changes_(system.law_states_change) {
    if (changes_) evaluateLawRates(system, states, rates_);
  }

  /// states: at the end of the drift, the laws' own still at its start.
  void finish(const System& system, double h, SystemState& states) const {
    if (!changes_) return;
    SystemState end = states;
    for (std::size_t k = 0; k < rates_.size(); ++k) end.laws[k] += h * rates_[k];
    std::vector<double> rates_at_end;
    evaluateLawRates(system, end, rates_at_end);
    for (std::size_t k = 0; k < rates_.size(); ++k)
      states.laws[k] += 0.5 * h * (rates_[k] + rates_at_end[k]);
  }

 private:
  bool changes_;
  std::vector<double> rates_;
};

/// One step. The wrenches at its end are those at the start of the next, so that each drift costs
/// one evaluation. drift(body, h, state) turns and moves a body without wrenches.
template <std::size_t kDrifts, class Drift>
void kickDriftKick(const KickDriftKick<kDrifts>& method, const Drift& drift, const System& system,
                   double h, SystemState& states, Workspace& workspace) {
  if (!workspace.wrenches_current) evaluateWrenches(system, states, workspace);
  for (std::size_t k = 0; k < kDrifts; ++k) {
    kickAll(system, method.kicks[k] * h, workspace.wrenches, states.bodies);
    const LawDrift laws(system, states);
    for (std::size_t i = 0; i < states.bodies.size(); ++i)
      drift(*system.bodies[i], method.drifts[k] * h, states.bodies[i]);
    laws.finish(system, method.drifts[k] * h, states);
    evaluateWrenches(system, states, workspace);
  }
  kickAll(system, method.kicks[kDrifts] * h, workspace.wrenches, states.bodies);
  workspace.wrenches_current = true;
}

/// One step that begins and ends with a drift.
template <std::size_t kKicks, class Drift>
void driftKickDrift(const DriftKickDrift<kKicks>& method, const Drift& drift, const System& system,
                    double h, SystemState& states, Workspace& workspace) {
  const auto driftAll = [&](double step) {
    for (std::size_t i = 0; i < states.bodies.size(); ++i)
      drift(*system.bodies[i], step, states.bodies[i]);
  };
  for (std::size_t k = 0; k < kKicks; ++k) {
    driftAll(method.drifts[k] * h);
    evaluateWrenches(system, states, workspace);
    kickAll(system, method.kicks[k] * h, workspace.wrenches, states.bodies);
  }
  driftAll(method.drifts[kKicks] * h);
  workspace.wrenches_current = false;
}

/// Free motion with the rotation split into three rotations: second order, symplectic, reversible.
struct SplitDrift {
  void operator()(const Body& body, double h, BodyState& s) const {
    driftPosition(body.mass, h, s);
    driftRotation(body.split, h, s);
  }
};

}  // namespace rigid_body_sim::methods
