#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "math/parabola.hpp"

namespace rigid_body_sim {

constexpr std::size_t kEighths = 8;

/// The polynomial of degree 8 through the values of a quantity at the ends and the eighths of a
/// piece of motion. Over a piece that an integrator follows, it errs by little more than that does.
class EighthsInterpolant {
 public:
  using Values = std::array<double, kEighths + 1>;

  explicit EighthsInterpolant(const Values& values);

  /// Where, in eighths from the start, it is least between two greater values, and how low there;
  /// neither end is such a place.
  std::vector<PointOfCurve> minima() const;

 private:
  static constexpr std::size_t kLooksBesideAnEnd = 5;
  static constexpr std::size_t kLooks = 8 * kEighths + 1 + 2 * kLooksBesideAnEnd;

  using Places = std::array<double, kLooks>;
  static Places placesToLook();

  std::array<double, kLooks> values_;
};

}  // namespace rigid_body_sim
