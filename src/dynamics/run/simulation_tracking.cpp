#include <algorithm>
#include <cmath>
#include <limits>

#include <rigid_body_sim/dynamics/simulation.hpp>

/// What runs beside a simulation where it is asked for: the run at twice the step that tells its
/// error, and its balance.
namespace rigid_body_sim {

void Simulation::trackError() {
  tracked_ = tracks_error_ = true;
  if (steps_ % 2 == 0) startCoarse();
}

bool Simulation::solvedToRounding(const Group& group) const {
  return !group.choice().method && !world_->solver.tolerance_stated;
}

/// Sets the second run off from the present state, at a step of even count.
void Simulation::startCoarse() {
  if (std::all_of(groups_.begin(), groups_.end(),
                  [this](const Group& group) { return solvedToRounding(group); }))
    return;
  World world = *world_;
  world.solver.time_step *= 2;
  world.solver.tolerance_stated = false;
  coarse_ = std::make_shared<Simulation>(*this);
  coarse_->world_ = std::make_shared<const World>(std::move(world));
  coarse_->stopTracking();
  coarse_->most_turn_share_ = 2;  // so that its parts, too, are twice as long
  coarse_->steps_ = steps_ / 2;
  coarse_->formGroupsAnew();
}

/// The second run, to be changed: a copy's is another.
Simulation& Simulation::ownCoarse() {
  if (coarse_.use_count() > 1) coarse_ = std::make_shared<Simulation>(*coarse_);
  return *coarse_;
}

void Simulation::trackBalance() {
  tracked_ = true;
  if (!balance_) balance_.emplace(*world_, state());
}

void Simulation::startBalance() {
  if (balance_) balance_.emplace(*world_, state());
}

Totals Simulation::balance() const {
  return balance_ ? balance_->remainder(*world_, state()) : Totals::unknown();
}

Totals Simulation::exchanged() const {
  return balance_ ? balance_->exchanged() : Totals::unknown();
}

void Simulation::stopTracking() {
  tracked_ = tracks_error_ = false;
  coarse_.reset();
  error_ = ErrorEstimate();
  balance_.reset();
}

void Simulation::followCoarse() {
  if (std::isinf(error_.attitude)) return;
  if (!coarse_) return startCoarse();
  try {
    while (2 * coarse_->steps_ < steps_) ownCoarse().step();
  } catch (const SimulationDiverged&) {
    error_.attitude = error_.position = std::numeric_limits<double>::infinity();
    return;
  }
  for (const Group& group : groups_) {
    if (solvedToRounding(group)) continue;
    // a solved motion is held against itself solved to rounding
    const double ratio = group.choice().method ? std::exp2(group.choice().method->order) - 1 : 1;
    for (std::size_t body : group.members()) {
      const BodyState &fine = state().bodies[body], &coarse = coarse_->state().bodies[body];
      error_.attitude = std::max(error_.attitude, angleBetween(fine.q_WP, coarse.q_WP) / ratio);
      error_.position = std::max(error_.position, (fine.x_W - coarse.x_W).norm() / ratio);
    }
  }
}

}  // namespace rigid_body_sim
