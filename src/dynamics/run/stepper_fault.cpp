#include <algorithm>
#include <cmath>
#include <sstream>
#include <vector>

#include "dynamics/rotation/free_motion.hpp"
#include "dynamics/run/stepper.hpp"
#include "dynamics/step_too_long.hpp"

/// What a step is refused for that takes more substeps than are reasonable.
namespace rigid_body_sim {
namespace {

/// The fastest so far, in words.
struct Fastest {
  double rate = -1;  // [1/s]
  std::string what, remedy;

  void offer(double other, const std::string& text, const std::string& instead) {
    if (other > rate || std::isnan(other)) *this = {other, text, instead};
  }
};

/// [1/s] What a law by itself brings about at these states.
double rateOf(const ForceLaw& law, const System& system, const ForceLaw::Bodies& at,
              const std::vector<double>& speeds) {
  std::vector<Stiffness> stiffness(system.bodies.size());
  law.addStiffness(system.bodies, stiffness);
  double rate = law.rate(at, speeds);
  for (const Stiffness& of_body : stiffness)
    rate = std::max({rate, std::sqrt(of_body.frequency_squared), of_body.decay});
  return rate;
}

}  // namespace

/// Names what turns, swings or decays fastest, and what would help.
void Stepper::failTooFast(const System& system, double h, const SystemState& states,
                          const std::string& limit) const {
  Fastest fastest;
  std::vector<double> speeds;
  for (std::size_t i = 0; i < states.bodies.size(); ++i) {
    const Body& body = *system.bodies[i];
    fastest.offer(stableNorm(angularVelocity(body.inv_I, states.bodies[i].L_P)),
                  i == 0 ? "its turning" : "the turning of body '" + body.name + "'",
                  "slower turning");
    speeds.push_back(stableNorm(states.bodies[i].p_W) / body.mass);
  }
  const auto offer = [&](const ForceLaw& law, const ForceLaw::Bodies& at) {
    const std::string name = law.name();
    const std::size_t body = law.members().front();
    const bool is_other = body > 0 && body < system.bodies.size();
    fastest.offer(rateOf(law, system, at, speeds),
                  "what " + name +
                      (is_other ? " on body '" + system.bodies[body]->name + "'" : "") +
                      " makes swing or slow down",
                  "weaker " + name);
  };
  const ForceLaw::Bodies at{system.bodies, states.bodies};
  for (const auto& law : system.laws) offer(*law, at);
  for (const auto& law : system.flows) offer(*law, at);
  forStatefulLaws(system, states, offer);
  if (torque_matters_)
    fastest.offer(rateBroughtAbout(system, h, states), "the turning that torques bring about",
                  "less torque");

  std::ostringstream reason;
  const double in_all = fastestRate(system, h, states);  // at the speeds that h may bring about
  const double turn = h * (std::isfinite(in_all) ? std::max(in_all, fastest.rate) : fastest.rate);
  if (std::isfinite(turn))
    reason << "a step spans " << turn << " rad of " << fastest.what << ", more than "
           << choice_.method->name << " follows in " << limit;
  else
    reason << fastest.what << " is faster than numbers reach";
  reason << "; a shorter time_step or " << fastest.remedy << " is needed";
  throw StepTooLong(reason.str());
}

}  // namespace rigid_body_sim
