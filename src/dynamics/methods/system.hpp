#pragma once

#include <cstdint>
#include <vector>

#include <rigid_body_sim/dynamics/force_law.hpp>

#include "dynamics/methods/state_dot.hpp"
#include "dynamics/wrenches/held_wrench.hpp"

namespace rigid_body_sim {

/// Bodies that act on one another, with all that acts on them between two events. What is absent
/// from the scene is absent here.
struct System {
  std::vector<const Body*> bodies;
  Vector3d g_W = Vector3d::Zero();   ///< [m/s²]
  std::vector<HeldWrench> held;      ///< one per body
  std::vector<PointWrench> coupled;  ///< whose axes or point turn with another body; indices are
                                     ///< those of this system
  ForceLaws laws;                    ///< indices likewise
  bool drags = false;                ///< whether any of the bodies has drag
};

/// What a method that estimates the error of its step lets the estimate reach before it takes the
/// step in parts. As it stands, beyond it an estimate means that the step cannot be followed.
struct StepBound {
  double error = 1e-4;  ///< [rad] of attitudes; of momenta relative to their size and change
  double idle = 1e-9;  ///< errors of momenta do not count that turn a body by less [rad] within the
                       ///< step, or move it by less of its radius of gyration
};

/// Memory that a method reuses from step to step.
struct Workspace {
  std::vector<Wrench> wrenches;  ///< at the present states, if wrenches_current
  bool wrenches_current = false;
  std::int64_t evaluations = 0;  ///< of all wrenches, since the workspace was made
  std::vector<BodyState> stages;
  std::vector<BodyStateDot> dots;
  StepBound step_bound;
};

/// Puts the wrench on each body, gravity included and drag left out, into workspace.wrenches.
void evaluateWrenches(const System& system, const std::vector<BodyState>& states,
                      Workspace& workspace);

/// As evaluateWrenches, without gravity and laws, but with drag: what has no potential energy.
void evaluateAppliedAndDrag(const System& system, const std::vector<BodyState>& states,
                            Workspace& workspace);

/// As evaluateWrenches, with drag.
void evaluateWrenchesAndDrag(const System& system, const std::vector<BodyState>& states,
                             Workspace& workspace);

}  // namespace rigid_body_sim
