#include <algorithm>
#include <chrono>

#include "ros/node/simulation_node.hpp"

/// How the node waits: for the next step, and in lockstep.
namespace rigid_body_sim {
namespace {

using SteadyClock = std::chrono::steady_clock;

}  // namespace

/// Serves callbacks until an instant of the outputs or the next step is due; while paused, for a
/// moment.
void SimulationNode::serveUntilDue() {
  serve(0);
  queues_.step_queue.callAvailable();
  if (paused_) {
    repeat();
    return serve(Timekeeper::kLongestWait);
  }
  while (!paused_ && ros::ok()) {
    if (lockstep_.isWaiting()) {
      serveInStep();
      lockstep_.checkPatience(SteadyClock::now());
      continue;
    }
    // anew each time: a callback may have set time back
    const double wait = time_.untilDue(outputs_.instantWithinStep().value_or(nextTime()));
    // a clock that stands may wait, in lockstep, for whoever comes to this node's topics
    if (time_.followsClock()) outputs_.setStanding(wait > 0);
    if (wait <= 0) return;
    const bool sleeps = maySleepOverSteps();
    if (sleeps) sleepOverSteps();
    serve(sleeps ? 0 : wait);
    queues_.step_queue.callAvailable();
  }
}

/// Whether steps may be taken later than they are due, though before anything is shown.
bool SimulationNode::maySleepOverSteps() {
  return !time_.followsClock() && !lockstep_.isOn() && !within_step_ && !outputs_.isWatched();
}

/// Waits for a callback until an instant of the outputs, and takes the steps that have become due
/// before: a callback finds time where it would be if each had been taken when it was due. A node
/// that nobody watches wakes up a hundred times a second, not a thousand times. No more steps are
/// slept over than are taken within half a step, so that the one after them is not late.
void SimulationNode::sleepOverSteps() {
  constexpr int kMaxSlept = 1 << 10;
  const double h = simulation_.world().solver.time_step;
  const double t_end = std::min(outputs_.nextInstant(), nextTime() + slept_over_ * h);
  queues_.queue.waitForCallback(time_.untilDue(t_end));
  const SteadyClock::time_point woken = SteadyClock::now();
  while (nextTime() < t_end && time_.wasDue(nextTime(), woken) && ros::ok()) advance();
  const std::chrono::duration<double> taken = SteadyClock::now() - woken;
  const double share = taken.count() * time_.realTimeFactor() / h;  // of a step
  if (share < 0.25) slept_over_ = std::min(2 * slept_over_, kMaxSlept);
  if (share > 0.5) slept_over_ = std::max(slept_over_ / 2, 1);
}

/// Where time goes in step with messages: publishes the state and lets time stand until they come.
void SimulationNode::waitInStep() {
  if (!lockstep_.isDueAt(simulation_.steps())) return;
  outputs_.setStanding(true);
  outputs_.publishNow();
  lockstep_.begin(inputs_.stamp(), SteadyClock::now());
}

/// Serves callbacks for a moment, and lets time go on once all messages have come.
void SimulationNode::serveInStep() {
  serve(lockstep_.hasAll() ? 0 : Timekeeper::kLongestWait);
  queues_.step_queue.callAvailable();
  takeInStep();
}

void SimulationNode::takeInStep() {
  if (!lockstep_.isWaiting()) return;
  if (!lockstep_.hasAll()) return repeat();
  lockstep_.takeAll();
  outputs_.setStanding(paused_);
}

/// While time stands, at a pace of its own: whoever comes finds a clock, and one who may have
/// answered in vain, in lockstep, the state.
void SimulationNode::repeat() {
  constexpr std::chrono::milliseconds kPeriod(100);
  const SteadyClock::time_point now = SteadyClock::now();
  if (now < next_repeat_) return;
  next_repeat_ = now + kPeriod;
  outputs_.repeatClock();
  if (lockstep_.isWaiting() && lockstep_.mayHaveLostAnswer()) outputs_.repeatState();
}

}  // namespace rigid_body_sim
