#include <algorithm>
#include <cmath>
#include <limits>

#include "tools/sweep/sweep_summary.hpp"

namespace rigid_body_sim {

/// Source: Welford, "Note on a method for calculating corrected sums of squares and products",
/// Technometrics 4 (1962).
void ColumnSummary::add(double x) {
  ++count;
  const double from_mean = x - mean;
  mean += from_mean / static_cast<double>(count);
  m2 += from_mean * (x - mean);
  least = count == 1 ? x : std::min(least, x);
  greatest = count == 1 ? x : std::max(greatest, x);
}

double ColumnSummary::stddev() const {
  return count < 2 ? 0 : std::sqrt(m2 / static_cast<double>(count - 1));
}

double ColumnSummary::percentile(double share) const {
  if (sorted_.empty()) {
    for (const double x : kept)
      if (!std::isnan(x)) sorted_.push_back(x);
    std::sort(sorted_.begin(), sorted_.end());
  }
  if (sorted_.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double place = share * static_cast<double>(sorted_.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted_.size() - 1);
  if (below == above || sorted_[below] == sorted_[above]) return sorted_[below];
  const double rest = place - static_cast<double>(below);
  return (1 - rest) * sorted_[below] + rest * sorted_[above];
}

void PairSummary::add(double x, double y) {
  ++count;
  const double n = static_cast<double>(count), dx = x - mean_x, dy = y - mean_y;
  mean_x += dx / n;
  mean_y += dy / n;
  m2_x += dx * (x - mean_x);
  m2_y += dy * (y - mean_y);
  covariance += dx * (y - mean_y);
}

std::optional<double> PairSummary::correlation() const {
  const double scale = std::sqrt(m2_x) * std::sqrt(m2_y);
  if (count < 2 || !(scale > 0) || !std::isfinite(scale)) return std::nullopt;
  return std::clamp(covariance / scale, -1.0, 1.0);
}

std::optional<std::size_t> SweepSummary::mostCorrelated(std::size_t result) const {
  std::optional<std::size_t> most;
  double greatest = 0;
  for (std::size_t i = 0; i < varied.size(); ++i) {
    const double size = std::abs(pairs[result][i].correlation().value_or(0));
    if (size <= greatest) continue;
    greatest = size;
    most = i;
  }
  return most;
}

}  // namespace rigid_body_sim
