#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

namespace rigid_body_sim {

/// The instants k / rate of simulation time, k = 0, 1, 2, …, each computed anew as a quotient, so
/// that rounding does not add up.
class Instants {
 public:
  /// rate [1/s] > 0. Begins with the first instant that is not before t [s].
  explicit Instants(double rate, double t = 0) : rate_(rate) { restart(t); }

  void restart(double t) {
    k_ = std::ceil(t * rate_);
    if (k_ > 0 && (k_ - 1) / rate_ >= t) k_ -= 1;
    if (next() < t) k_ += 1;
  }

  double next() const { return k_ / rate_; }

  /// Goes on to the first instant after t [s].
  void passTo(double t) {
    if (next() > t) return;
    k_ = std::floor(t * rate_);
    while (next() <= t) k_ = std::max(k_ + 1, std::nextafter(k_, kInfinity));
  }

  /// The number k of the last instant from `from` to `reach` [s], where there is one; all instants
  /// up to there have passed then.
  std::optional<std::uint64_t> take(double from, double reach) {
    if (next() > reach) return std::nullopt;
    passTo(reach);
    if ((k_ - 1) / rate_ < from) return std::nullopt;
    return static_cast<std::uint64_t>(k_ - 1);
  }

 private:
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();

  double rate_;
  double k_ = 0;  // whole; beyond 2^53 some numbers are left out
};

}  // namespace rigid_body_sim
