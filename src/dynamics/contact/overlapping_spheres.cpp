#include "dynamics/contact/overlapping_spheres.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigid_body_sim {
namespace {

/// The axis along which the centres vary most.
Eigen::Index widestAxis(const std::vector<BoundingSphere>& spheres) {
  Vector3d mean = Vector3d::Zero(), square = Vector3d::Zero();
  const double share = 1 / static_cast<double>(spheres.size());
  for (const BoundingSphere& sphere : spheres) mean += share * sphere.center;
  for (const BoundingSphere& sphere : spheres) square += (sphere.center - mean).cwiseAbs2();
  Eigen::Index axis = 0;
  square.maxCoeff(&axis);
  return axis;
}

/// Also where a distance or a radius is not finite.
bool overlap(const BoundingSphere& a, const BoundingSphere& b) {
  const double reach = a.radius + b.radius;
  return !((a.center - b.center).squaredNorm() > reach * reach);
}

struct Extent {
  double low, high;
  std::size_t sphere;
};

}  // namespace

std::vector<std::pair<std::size_t, std::size_t>> overlappingSpheres(
    const std::vector<BoundingSphere>& spheres) {
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  if (spheres.empty()) return pairs;
  const Eigen::Index axis = widestAxis(spheres);
  // rounding of the ends must not part spheres that touch
  constexpr double kNever = std::numeric_limits<double>::infinity();
  constexpr double kMargin = 4 * std::numeric_limits<double>::epsilon();
  std::vector<Extent> extents;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    const double center = spheres[i].center[axis], radius = spheres[i].radius;
    const double reach = radius + kMargin * (std::abs(center) + radius);
    if (radius < 0) continue;
    if (std::isfinite(center) && std::isfinite(reach))
      extents.push_back({center - reach, center + reach, i});
    else
      extents.push_back({-kNever, kNever, i});
  }
  std::sort(extents.begin(), extents.end(), [](const Extent& a, const Extent& b) {
    return a.low < b.low || (a.low == b.low && a.sphere < b.sphere);
  });
  for (auto a = extents.begin(); a != extents.end(); ++a)
    for (auto b = a + 1; b != extents.end() && b->low <= a->high; ++b)
      if (overlap(spheres[a->sphere], spheres[b->sphere]))
        pairs.emplace_back(std::minmax(a->sphere, b->sphere));
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace rigid_body_sim
