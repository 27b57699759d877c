#include "ros/clock/pacer.hpp"

#include <algorithm>

namespace rigid_body_sim {

void Pacer::restart(double t, Clock::time_point now) {
  origin_t_ = t;
  origin_ = now;
}

void Pacer::setFactor(double real_time_factor, double next, Clock::time_point now) {
  const double elapsed = std::chrono::duration<double>(now - origin_).count();
  const double due = origin_t_ + elapsed * real_time_factor_;
  restart(real_time_factor_ > 0 ? std::min(due, next) : next, now);
  real_time_factor_ = real_time_factor;
}

double Pacer::wait(double t, Clock::time_point now) const {
  if (!(real_time_factor_ > 0)) return 0;
  const double elapsed = std::chrono::duration<double>(now - origin_).count();
  return (t - origin_t_) / real_time_factor_ - elapsed;
}

void Pacer::begin(double t, double h, Clock::time_point now) {
  if (!(real_time_factor_ > 0)) return;
  const double late = -wait(t, now);
  if (late > h / real_time_factor_) ++overruns_;
  if (late > kBacklogLimit) restart(t, now);
}

void Pacer::dropBacklog(double t, Clock::time_point now) {
  if (real_time_factor_ > 0 && wait(t, now) < -kBacklogLimit) restart(t, now);
}

}  // namespace rigid_body_sim
