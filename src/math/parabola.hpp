#pragma once

namespace rigid_body_sim {

struct PointOfCurve {
  double x, y;
};

/// Where the parabola through three points, x ascending, is level. It is no number where they lie
/// on a line.
inline PointOfCurve vertexOf(const PointOfCurve& a, const PointOfCurve& b, const PointOfCurve& c) {
  const double left = (b.y - a.y) / (b.x - a.x), right = (c.y - b.y) / (c.x - b.x);
  const double curvature = (right - left) / (c.x - a.x);
  const double slope = left + curvature * (b.x - a.x);  // at b
  const double step = -0.5 * slope / curvature;
  return {b.x + step, b.y + (slope + curvature * step) * step};
}

}  // namespace rigid_body_sim
