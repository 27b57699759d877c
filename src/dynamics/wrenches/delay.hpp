#pragma once

namespace rigid_body_sim {

/// What was to act from before the time t [s] on, a wrench or a command, acts from there on, for as
/// long.
template <class Timed>
void delayTo(double t, Timed& timed) {
  if (!(timed.start < t)) return;
  timed.end += t - timed.start;
  timed.start = t;
}

}  // namespace rigid_body_sim
