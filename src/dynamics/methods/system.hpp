#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <rigid_body_sim/dynamics/force_law.hpp>

#include "dynamics/methods/state_dot.hpp"
#include "dynamics/wrenches/held_wrench.hpp"

namespace rigid_body_sim {

class ActuatorLaw;

/// Bodies that act on one another, with all that acts on them between two events. What is absent
/// from the scene is absent here. Indices of bodies are those of this system.
struct System {
  /// A law that has states of its own, and the first of them in SystemState::laws.
  struct StatefulLaw {
    std::shared_ptr<const ForceLaw> law;
    std::size_t first;
  };

  /// A body with actuators: their law, which is one of stateful_laws, and its state.
  struct Driven {
    const ActuatorLaw* law;
    std::size_t body;
    std::size_t state;  ///< the time since the law's drive started, in SystemState::laws
  };

  /// A body on a pivot: of what is held only the torque about the pivot is part of `held`, that of
  /// gravity included.
  struct Pivot {
    std::size_t body;
    Vector3d g_W;                                             ///< [m/s²]
    Vector3d f_W = Vector3d::Zero(), f_P = Vector3d::Zero();  ///< [N] forces held, gravity included
  };

  std::vector<const Body*> bodies;
  Vector3d g_W = Vector3d::Zero();       ///< [m/s²]; zero where the only body is on a pivot
  std::vector<HeldWrench> held;          ///< one per body
  std::vector<PointWrench> coupled;      ///< whose axes or point turn with another body
  ForceLaws laws;                        ///< without states of their own and without a flow
  ForceLaws flows;                       ///< laws with a flow
  std::vector<const ForceLaw*> flow_of;  ///< that on each body or null; empty where there is none
  std::vector<StatefulLaw> stateful_laws;
  std::vector<Driven> driven;
  std::vector<Pivot> pivots;
  std::shared_ptr<const MediumLoad> medium;  ///< on the only body, where it is solved for
  bool torque_free = false;                  ///< whether nothing that acts exerts a torque
  bool law_states_change = false;            ///< with time, not only from mode to mode
  bool has_events = false;                   ///< whether any law has guards
  bool has_contact = false;                  ///< whether any law needs kContact
  double event_precision = 0;  ///< share of a step to which events are located; 0: to rounding
};

/// What changes about a system.
struct SystemState {
  std::vector<BodyState> bodies;
  std::vector<double> laws;
};

/// Largest error estimate of a step before the step is divided into substeps; by default, beyond it
/// the step cannot be followed.
struct StepBound {
  double error = 1e-4;  ///< [rad] of attitudes; of momenta relative to their size and change
  double idle = 1e-9;  ///< errors of momenta do not exceed it that turn a body by less [rad] in the
                       ///< step, or move it by less of its radius of gyration
  double least_share = 0;  ///< the estimate is no less than this share of that of order 3, to the
                           ///< power 9/4 by which an error of order 8 grows beside it
};

/// Of StepBound::idle: no less than what rounding moves a body by that lies.
constexpr double kLeastIdle = 1e-16;

/// Memory that an integrator reuses from step to step.
struct Workspace {
  std::vector<Wrench> wrenches;  ///< at the present states, if wrenches_current
  bool wrenches_current = false;
  std::int64_t evaluations = 0;  ///< of all wrenches, since the workspace was made
  std::int64_t rough_steps = 0;  ///< since then: those whose estimate hardly fell by halving them
  SystemState stages;
  std::vector<BodyStateDot> dots;
  std::vector<double> law_dots;
  std::vector<std::size_t> moving_laws;  // states of laws that move within a step
  std::vector<char> has_moved;           // state by state
  StepBound step_bound;
  double error = 0;  ///< estimated by the last step (Claim kEstimatesError); infinity: not followed
};

/// Calls f(law, at) for each law of the system with states of its own.
template <class F>
void forStatefulLaws(const System& system, const SystemState& states, const F& f) {
  for (const System::StatefulLaw& stateful : system.stateful_laws)
    f(*stateful.law,
      ForceLaw::Bodies{system.bodies, states.bodies, states.laws.data() + stateful.first});
}

/// Puts the wrench on each body, gravity included and laws with a flow left out, into
/// workspace.wrenches.
void evaluateWrenches(const System& system, const SystemState& states, Workspace& workspace);

/// As evaluateWrenches, without gravity and laws, but with laws that have a flow.
void evaluateAppliedAndFlows(const System& system, const SystemState& states, Workspace& workspace);

/// As evaluateWrenches, with the laws that have a flow.
void evaluateAllWrenches(const System& system, const SystemState& states, Workspace& workspace);

/// evaluateAllWrenches and evaluateLawRates at once.
void evaluateAllWithRates(const System& system, const SystemState& states, Workspace& workspace,
                          std::vector<double>& rates);

/// Rates of the laws' own states.
void evaluateLawRates(const System& system, const SystemState& states, std::vector<double>& rates);

/// Adds to L_W, where it is R L_P, what wheels and rotors have.
void addSpin(const System& system, SystemState& states);

/// Sum of the external powers of all laws [W].
double externalPower(const System& system, const SystemState& states);

}  // namespace rigid_body_sim
