#include "dynamics/run/balance.hpp"

namespace rigid_body_sim {

ExchangeMeter& Balance::beginStep() {
  meter_.take();  // of a step that was not done
  return meter_;
}

void Balance::endStep() {
  const Totals step = meter_.take();
  work_.add(step.energy);
  impulse_.add(step.momentum);
  angular_impulse_.add(step.angular_momentum);
}

void Balance::addChange(const Totals& before, const Totals& after, bool with_momenta) {
  work_.add(after.energy - before.energy);
  if (!with_momenta) return;
  impulse_.add(after.momentum - before.momentum);
  angular_impulse_.add(after.angular_momentum - before.angular_momentum);
}

Totals Balance::exchanged() const {
  return {work_.value(), impulse_.value(), angular_impulse_.value()};
}

Totals Balance::remainder(const World& world, const State& now) const {
  const Totals has = totalsOf(world, now), gained = exchanged();
  return {has.energy - start_.energy - gained.energy,
          has.momentum - start_.momentum - gained.momentum,
          has.angular_momentum - start_.angular_momentum - gained.angular_momentum};
}

}  // namespace rigid_body_sim
