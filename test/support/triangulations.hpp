#pragma once

#include <cmath>
#include <vector>

#include <rigid_body_sim/mass/shapes.hpp>
#include <rigid_body_sim/mass/triangle_mesh.hpp>

namespace rigid_body_sim {

/// Triangulations of the shapes, inscribed, oriented outwards, each vertex stored once. n: segments
/// of a full turn; the error of the integrals falls with 1/n².

/// The solid of revolution about z under a profile of points (radius, z) that rises from the bottom
/// to the top; both ends lie on the axis, the others beside it.
inline TriangleMesh revolved(const std::vector<Eigen::Vector2d>& profile, std::uint32_t n) {
  TriangleMesh mesh;
  const auto rings = static_cast<std::uint32_t>(profile.size()) - 2;
  mesh.vertices.emplace_back(0, 0, profile.front().y());
  for (std::uint32_t ring = 0; ring < rings; ++ring)
    for (std::uint32_t k = 0; k < n; ++k) {
      const double angle = 2 * M_PI * k / n;
      const Eigen::Vector2d& p = profile[ring + 1];
      mesh.vertices.emplace_back(p.x() * std::cos(angle), p.x() * std::sin(angle), p.y());
    }
  mesh.vertices.emplace_back(0, 0, profile.back().y());

  const auto at = [n](std::uint32_t ring, std::uint32_t k) { return 1 + ring * n + k % n; };
  const auto top = static_cast<std::uint32_t>(mesh.vertices.size()) - 1;
  for (std::uint32_t k = 0; k < n; ++k) {
    mesh.triangles.push_back({0, at(0, k + 1), at(0, k)});
    for (std::uint32_t ring = 0; ring + 1 < rings; ++ring) {
      mesh.triangles.push_back({at(ring, k), at(ring, k + 1), at(ring + 1, k + 1)});
      mesh.triangles.push_back({at(ring, k), at(ring + 1, k + 1), at(ring + 1, k)});
    }
    mesh.triangles.push_back({at(rings - 1, k), at(rings - 1, k + 1), top});
  }
  return mesh;
}

inline TriangleMesh triangulated(const Box& box, std::uint32_t /*n*/) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.vertices.push_back(Vector3d(i & 1 ? 0.5 : -0.5, i & 2 ? 0.5 : -0.5, i & 4 ? 0.5 : -0.5)
                                .cwiseProduct(box.size));
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// Two half circles of the given radius, `length` apart.
inline TriangleMesh triangulated(const Capsule& c, std::uint32_t n) {
  std::vector<Eigen::Vector2d> profile{{0, -c.length / 2 - c.radius}};
  const std::uint32_t quarter = n / 4;
  for (std::uint32_t i = 1; i <= quarter; ++i) {
    const double angle = M_PI / 2 * i / quarter;
    profile.emplace_back(c.radius * std::sin(angle), -c.length / 2 - c.radius * std::cos(angle));
  }
  for (std::uint32_t i = c.length > 0 ? 0 : 1; i < quarter; ++i) {
    const double angle = M_PI / 2 * i / quarter;
    profile.emplace_back(c.radius * std::cos(angle), c.length / 2 + c.radius * std::sin(angle));
  }
  profile.emplace_back(0, c.length / 2 + c.radius);
  return revolved(profile, n);
}

inline TriangleMesh triangulated(const Sphere& s, std::uint32_t n) {
  return triangulated(Capsule{s.radius, 0}, n);
}

inline TriangleMesh triangulated(const Cylinder& c, std::uint32_t n) {
  const double r = c.radius, h = c.length / 2;
  return revolved({{0, -h}, {r, -h}, {r, h}, {0, h}}, n);
}

inline TriangleMesh triangulated(const Cone& c, std::uint32_t n) {
  const double l = c.length;
  return revolved({{0, -l / 4}, {c.radius, -l / 4}, {0, 3 * l / 4}}, n);
}

inline TriangleMesh triangulated(const Ellipsoid& e, std::uint32_t n) {
  TriangleMesh mesh = triangulated(Sphere{1}, n);
  for (Vector3d& v : mesh.vertices) v = v.cwiseProduct(e.semi_axes);
  return mesh;
}

inline TriangleMesh triangulated(const Shape& shape, std::uint32_t n) {
  return std::visit([n](const auto& s) { return triangulated(s, n); }, shape);
}

inline TriangleMesh cube(double size = 1) { return triangulated(Box{{size, size, size}}, 0); }

inline MassProperties ofDensityOne(const Shape& shape) {
  return massProperties(shape, volume(shape));
}
inline MassProperties ofDensityOne(const TriangleMesh& mesh) {
  return massProperties(mesh, volume(mesh));
}

}  // namespace rigid_body_sim
