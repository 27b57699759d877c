#include <stdexcept>
#include <utility>

#include <rigid_body_sim/dynamics/step_sampler.hpp>

#include "dynamics/run/run.hpp"
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

State StepSampler::at(double t) {
  ahead_->goOnTo(t);
  return ahead_->run().sample(t);
}

std::int64_t StepSampler::evaluations() const { return ahead_->run().now().counts().evaluations; }

}  // namespace rigid_body_sim
