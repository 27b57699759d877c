#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace rigid_body_sim::test {

/// Errors over a ladder of steps, down to where rounding begins to show.
class Ladder {
 public:
  explicit Ladder(double floor) : floor_(floor) {}

  void add(int steps, double error) {
    done_ = done_ || error < floor_;
    if (!done_) points_.push_back({std::log(1.0 / steps), std::log(error)});
  }

  /// Of log error against log step, fitted to the finest.
  std::optional<double> slope(std::size_t finest) const {
    const std::size_t first = points_.size() > finest ? points_.size() - finest : 0;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (std::size_t i = first; i < points_.size(); ++i)
      mean += points_[i] / static_cast<double>(points_.size() - first);
    double xx = 0, xy = 0;
    for (std::size_t i = first; i < points_.size(); ++i) {
      const Eigen::Vector2d d = points_[i] - mean;
      xx += d.x() * d.x();
      xy += d.x() * d.y();
    }
    return xx > 0 ? std::optional<double>(xy / xx) : std::nullopt;
  }

 private:
  double floor_;
  bool done_ = false;
  std::vector<Eigen::Vector2d> points_;
};

}  // namespace rigid_body_sim::test
