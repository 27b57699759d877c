#include "scene/meshes/number_precision.hpp"

#include <algorithm>
#include <cmath>

namespace rigid_body_sim {
namespace {

constexpr int kDigitsOfSingle = 9;  // as many as tell all numbers of single precision apart

/// From the first digit that is not zero to the last before an exponent.
int significantDigits(std::string_view word) {
  int digits = 0;
  for (const char c : word) {
    if (c == 'e' || c == 'E') break;
    if (c >= '0' && c <= '9' && (digits > 0 || c != '0')) ++digits;
  }
  return digits;
}

/// One of single precision, written with ten digits or more.
bool isSingle(double value) {
  const double nearest = static_cast<double>(static_cast<float>(value));
  return std::abs(nearest - value) <= 5e-10 * std::abs(value);
}

}  // namespace

void NumberPrecision::add(std::string_view word, double value) {
  digits_ = std::max(digits_, significantDigits(word));
  all_single_ = all_single_ && isSingle(value);
}

double NumberPrecision::rounding(const std::vector<Vector3d>& vertices) const {
  double largest = 0;
  for (const Vector3d& v : vertices) largest = std::max(largest, v.cwiseAbs().maxCoeff());
  if (!(largest > 0) || !std::isfinite(largest)) return 0;
  const bool single = digits_ <= kDigitsOfSingle || all_single_;
  const double ulp = std::ldexp(1.0, std::ilogb(largest) - (single ? 23 : 52));
  if (digits_ == 0) return 4 * ulp;
  const int leading = static_cast<int>(std::floor(std::log10(largest)));
  const double last_digit = std::pow(10.0, leading + 1 - std::max(digits_, 6));
  return 4 * ulp + 1.5 * last_digit;
}

}  // namespace rigid_body_sim
