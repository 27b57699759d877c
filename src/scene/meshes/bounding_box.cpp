#include "scene/meshes/bounding_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace rigid_body_sim {
namespace {

using Vector2d = Eigen::Vector2d;
using Points = std::vector<Vector3d>;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Corners of the convex hull in the plane, counter-clockwise (Andrew's monotone chain).
std::vector<Vector2d> planeHull(std::vector<Vector2d> points) {
  const auto less = [](const Vector2d& a, const Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  };
  std::sort(points.begin(), points.end(), less);
  std::vector<Vector2d> hull;
  for (int side = 0; side < 2; ++side) {  // below, then above
    const std::size_t first = hull.size();
    for (const Vector2d& p : points) {
      while (hull.size() >= first + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0)
        hull.pop_back();
      hull.push_back(p);
    }
    hull.pop_back();  // begins the other side
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

/// The direction of a side of the rectangle of least area around a convex polygon: one along an
/// edge of it (Freeman & Shapira 1975), found by rotating calipers (Toussaint 1983).
Vector2d sideOfLeastRectangle(const std::vector<Vector2d>& hull) {
  const std::size_t n = hull.size();
  Vector2d best(1, 0);
  double least = std::numeric_limits<double>::infinity();
  std::array<std::size_t, 3> support{1, 1, 1};  // farthest along, across and back
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d along = (hull[(i + 1) % n] - hull[i]).normalized();
    const std::array<Vector2d, 3> directions{along, Vector2d(-along.y(), along.x()), -along};
    for (std::size_t k = 0; k < 3; ++k) {
      if (k > 0) support[k] = std::max(support[k], support[k - 1]);
      while (support[k] < i + 2 * n &&
             directions[k].dot(hull[(support[k] + 1) % n] - hull[support[k] % n]) > 0)
        ++support[k];
    }
    const double length = along.dot(hull[support[0] % n] - hull[support[2] % n]);
    const double width = directions[1].dot(hull[support[1] % n] - hull[i]);
    if (!(length * width < least)) continue;
    least = length * width;
    best = along;
  }
  return best;
}

/// A box by its axes (columns) and what it spans along them.
struct AlongAxes {
  Matrix3d axes;
  Eigen::AlignedBox3d span;
  double volume() const { return span.sizes().prod(); }
};

AlongAxes spanOf(const Points& points, const Matrix3d& axes) {
  AlongAxes box{axes, {}};
  for (const Vector3d& p : points) box.span.extend(Vector3d(axes.transpose() * p));
  return box;
}

/// The smallest box that has an axis along n.
AlongAxes smallestAbout(const Vector3d& n, const Points& points) {
  const Vector3d u = n.unitOrthogonal(), v = n.cross(u);
  std::vector<Vector2d> flat;
  flat.reserve(points.size());
  for (const Vector3d& p : points) flat.emplace_back(u.dot(p), v.dot(p));
  const Vector2d side = sideOfLeastRectangle(planeHull(std::move(flat)));
  Matrix3d axes;
  axes.col(0) = (side.x() * u + side.y() * v).normalized();
  axes.col(1) = n.cross(axes.col(0)).normalized();
  axes.col(2) = n;
  return spanOf(points, axes);
}

/// Normals of the largest triangles, none of no area.
Points normalsOfLargest(const TriangleMesh& hull, std::size_t most) {
  Points normals;
  for (const Triangle& t : hull.triangles) {
    const Vector3d& a = hull.vertices[t[0]];
    normals.push_back((hull.vertices[t[1]] - a).cross(hull.vertices[t[2]] - a));
  }
  std::stable_sort(normals.begin(), normals.end(), [](const Vector3d& a, const Vector3d& b) {
    return a.squaredNorm() > b.squaredNorm();
  });
  if (normals.size() > most) normals.resize(most);
  while (normals.size() > 1 && !(normals.back().norm() > 0)) normals.pop_back();
  for (Vector3d& n : normals) n.normalize();
  return normals;
}

AlongAxes turnedWhileItShrinks(AlongAxes box, const Points& points) {
  constexpr int kMaxTurns = 12;
  for (int turn = 0, in_vain = 0; turn < kMaxTurns && in_vain < 3; ++turn) {
    const AlongAxes turned = smallestAbout(box.axes.col(turn % 3), points);
    const bool shrinks = turned.volume() < (1 - 1e-9) * box.volume();
    if (shrinks) box = turned;
    in_vain = shrinks ? 0 : in_vain + 1;
  }
  return box;
}

TriangleMesh meshOf(const AlongAxes& box, const Vector3d& origin) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i) {
    const auto corner = static_cast<Eigen::AlignedBox3d::CornerType>(i);  // bits: x, y, z
    mesh.vertices.push_back(origin + box.axes * box.span.corner(corner));
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

}  // namespace

TriangleMesh boundingBox(const TriangleMesh& hull) {
  const Vector3d origin = hull.vertices.front();
  Points points = hull.vertices;
  for (Vector3d& p : points) p -= origin;
  const std::size_t most = std::clamp<std::size_t>(2000000 / points.size(), 6, 200);
  AlongAxes best = spanOf(points, Matrix3d::Identity());
  for (const Vector3d& n : normalsOfLargest(hull, most)) {
    const AlongAxes box = smallestAbout(n, points);
    if (box.volume() < best.volume()) best = box;
  }
  return meshOf(turnedWhileItShrinks(best, points), origin);
}

}  // namespace rigid_body_sim
