#include "mass/shell_crossing.hpp"

namespace rigid_body_sim {
namespace {

Eigen::AlignedBox3d boxOf(const TriangleMesh& mesh, std::uint32_t k) {
  Eigen::AlignedBox3d box;
  for (const std::uint32_t corner : mesh.triangles[k]) box.extend(mesh.vertices[corner]);
  return box;
}

std::vector<std::uint32_t> trianglesIn(const Eigen::AlignedBox3d& box, const TriangleMesh& mesh,
                                       const Shell& shell) {
  std::vector<std::uint32_t> found;
  for (const std::uint32_t k : shell.triangles)
    if (box.intersects(boxOf(mesh, k))) found.push_back(k);
  return found;
}

/// Whether the way from p to q passes through the inside of the triangle.
bool passes(const Vector3d& p, const Vector3d& q, const TriangleMesh& mesh, const Triangle& t,
            double tolerance) {
  const Vector3d& a = mesh.vertices[t[0]];
  const Vector3d ab = mesh.vertices[t[1]] - a, ac = mesh.vertices[t[2]] - a;
  const Vector3d normal = ab.cross(ac);
  const double twice_area = normal.norm();
  const double height_p = normal.dot(p - a) / twice_area;
  const double height_q = normal.dot(q - a) / twice_area;
  const bool falls = height_p > tolerance && height_q < -tolerance;
  const bool rises = height_p < -tolerance && height_q > tolerance;
  if (!falls && !rises) return false;
  const Vector3d at = p + height_p / (height_p - height_q) * (q - p) - a;
  constexpr double kMargin = 1e-6;  // of the triangle: what grazes its edge only touches
  const double along_ab = normal.dot(at.cross(ac)) / (twice_area * twice_area);
  const double along_ac = normal.dot(ab.cross(at)) / (twice_area * twice_area);
  return along_ab > kMargin && along_ac > kMargin && along_ab + along_ac < 1 - kMargin;
}

bool anEdgePasses(const TriangleMesh& mesh, const Triangle& edges_of, const Triangle& through,
                  double tolerance) {
  for (std::size_t i = 0; i < 3; ++i)
    if (passes(mesh.vertices[edges_of[i]], mesh.vertices[edges_of[(i + 1) % 3]], mesh, through,
               tolerance))
      return true;
  return false;
}

}  // namespace

CommonTriangles commonTriangles(const TriangleMesh& mesh, const Shell& a, const Shell& b) {
  const Eigen::AlignedBox3d common = a.box.intersection(b.box);
  return {trianglesIn(common, mesh, a), trianglesIn(common, mesh, b)};
}

bool cross(const TriangleMesh& mesh, const CommonTriangles& common, double tolerance) {
  std::vector<Eigen::AlignedBox3d> boxes_b;
  boxes_b.reserve(common.b.size());
  for (const std::uint32_t k : common.b) boxes_b.push_back(boxOf(mesh, k));
  for (const std::uint32_t i : common.a) {
    const Eigen::AlignedBox3d box_a = boxOf(mesh, i);
    for (std::size_t k = 0; k < common.b.size(); ++k) {
      if (!box_a.intersects(boxes_b[k])) continue;
      const Triangle& a = mesh.triangles[i];
      const Triangle& b = mesh.triangles[common.b[k]];
      if (anEdgePasses(mesh, a, b, tolerance) || anEdgePasses(mesh, b, a, tolerance)) return true;
    }
  }
  return false;
}

}  // namespace rigid_body_sim
