#include <cmath>
#include <stdexcept>
#include <utility>

#include <rigid_body_sim/dynamics/contact_point.hpp>
#include <rigid_body_sim/dynamics/step_sampler.hpp>

#include "dynamics/require.hpp"
#include "dynamics/run/check_input.hpp"
#include "dynamics/run/run.hpp"
#include "math/instant_rounding.hpp"
#include "math/shortest.hpp"

namespace rigid_body_sim {

/// A run that goes on within the step.
class StepSampler::Ahead {
 public:
  explicit Ahead(const Simulation& simulation)
      : run_(std::make_shared<const World>(simulation.world()),
             std::make_shared<const State>(simulation.state())),
        end_(static_cast<double>(simulation.steps() + 1) * simulation.world().solver.time_step) {}

  void goOnTo(double t) {
    const double now = run_.now().time;
    if (!(t >= now && t <= end_))
      throw std::invalid_argument("a sample at " + shortest(t) + " s is not between " +
                                  shortest(now) + " s and the end of the step at " +
                                  shortest(end_) + " s");
    if (t > now) run_.stepPart(t);
  }

  const Run& run() const { return run_; }

 private:
  Run run_;
  double end_;
};

StepSampler::StepSampler(const Simulation& simulation)
    : ahead_(std::make_unique<Ahead>(simulation)) {}
StepSampler::~StepSampler() = default;
StepSampler::StepSampler(StepSampler&& other) noexcept = default;
StepSampler& StepSampler::operator=(StepSampler&& other) noexcept = default;

void StepSampler::goTo(double t) { ahead_->goOnTo(t); }

State StepSampler::at(double t) {
  ahead_->goOnTo(t);
  return ahead_->run().sample(t);
}

std::vector<BodyMotion> StepSampler::motions(const std::vector<std::size_t>& bodies, double t) {
  for (std::size_t body : bodies) checkIndex(*ahead_->run().now().world, body);
  ahead_->goOnTo(t);
  return ahead_->run().motions(bodies, t);
}

std::int64_t StepSampler::evaluations() const { return ahead_->run().now().evaluations(); }

StatesWithin::StatesWithin(double rate) : rate_(rate) {
  require(rate > 0 && std::isfinite(rate), "a rate must be > 0 and finite", Got{rate});
}

/// What to ask in place of the simulation; null for the first instant of a step.
StepSampler* StatesWithin::samplerFor(const Simulation& simulation, double t) {
  const bool goes_on = simulation.steps() == step_ && t >= last_;
  if (!goes_on) {
    restart();
    step_ = simulation.steps();
    last_ = t;
  }
  if (rate_ > 0)
    goThrough(simulation, t);
  else if (!sampler_ && t > last_ && hasOneSidedLaw(simulation.world()))
    sampler_.emplace(simulation);
  last_ = t;
  return sampler_ ? &*sampler_ : nullptr;
}

/// The instants before t, in contact. One that misses the step by rounding is not within it.
void StatesWithin::goThrough(const Simulation& simulation, double t) {
  const double from = sampler_ ? last_ : simulation.time();
  const double rounding = instantRounding(t, simulation.world().solver.time_step);
  if (!hasOneSidedLaw(simulation.world())) return;
  for (double k = std::floor(from * rate_) + 1; k / rate_ < t - rounding; ++k) {
    if (!(k / rate_ > from + rounding)) continue;
    if (!sampler_) sampler_.emplace(simulation);
    sampler_->goTo(k / rate_);
  }
}

State StatesWithin::at(const Simulation& simulation, double t) {
  StepSampler* sampler = samplerFor(simulation, t);
  return sampler ? sampler->at(t) : simulation.sample(t);
}

std::vector<BodyMotion> StatesWithin::motions(const Simulation& simulation,
                                              const std::vector<std::size_t>& bodies, double t) {
  StepSampler* sampler = samplerFor(simulation, t);
  return sampler ? sampler->motions(bodies, t) : simulation.motions(bodies, t);
}

void StatesWithin::restart() {
  step_ = -1;
  sampler_.reset();
}

}  // namespace rigid_body_sim
