#pragma once

#include <utility>

#include <rigid_body_sim/mass/triangle_mesh.hpp>

namespace rigid_body_sim {

/// Changes of meshes that tests need; values in, values out.

inline TriangleMesh transformed(const Isometry3d& X_AB, TriangleMesh mesh) {
  for (Vector3d& v : mesh.vertices) v = X_AB * v;
  return mesh;
}

inline TriangleMesh translated(const Vector3d& by, TriangleMesh mesh) {
  for (Vector3d& v : mesh.vertices) v += by;
  return mesh;
}

inline TriangleMesh scaled(double by, TriangleMesh mesh) {
  for (Vector3d& v : mesh.vertices) v *= by;
  return mesh;
}

inline TriangleMesh insideOut(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

inline TriangleMesh together(TriangleMesh a, const TriangleMesh& b) {
  const auto offset = static_cast<std::uint32_t>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const Triangle& t : b.triangles)
    a.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return a;
}

/// Every triangle with three vertices of its own, as STL stores them.
inline TriangleMesh soup(const TriangleMesh& mesh) {
  TriangleMesh loose;
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<std::uint32_t>(loose.vertices.size());
    for (const std::uint32_t corner : t) loose.vertices.push_back(mesh.vertices[corner]);
    loose.triangles.push_back({first, first + 1, first + 2});
  }
  return loose;
}

/// The part of the solid where n · x > h, as a soup. Every triangle is cut at the plane; the cut
/// face is the fan of all new edges about one point of the plane, which closes the surface whatever
/// its outline, for what the fan covers too much it covers once each way.
inline TriangleMesh above(const TriangleMesh& mesh, const Vector3d& n, double h) {
  TriangleMesh part;
  const auto addTriangle = [&part](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const auto first = static_cast<std::uint32_t>(part.vertices.size());
    part.vertices.insert(part.vertices.end(), {a, b, c});
    part.triangles.push_back({first, first + 1, first + 2});
  };
  const Vector3d hub = h * n / n.squaredNorm();
  for (const Triangle& t : mesh.triangles) {
    std::vector<Vector3d> kept, cut;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3d& p = mesh.vertices[t[i]];
      const Vector3d& q = mesh.vertices[t[(i + 1) % 3]];
      const double over_p = n.dot(p) - h, over_q = n.dot(q) - h;
      if (over_p > 0) kept.push_back(p);
      if ((over_p > 0) != (over_q > 0)) {
        // always from the side above, so that both neighbours of the edge find the same point
        const Vector3d on_plane = over_p > 0 ? Vector3d(p + over_p / (over_p - over_q) * (q - p))
                                             : Vector3d(q + over_q / (over_q - over_p) * (p - q));
        // leaving: the new edge starts here; coming back: it ends here
        cut.insert(over_p > 0 ? cut.begin() : cut.end(), on_plane);
        kept.push_back(on_plane);
      }
    }
    for (std::size_t i = 1; i + 1 < kept.size(); ++i) addTriangle(kept[0], kept[i], kept[i + 1]);
    if (cut.size() == 2) addTriangle(hub, cut[1], cut[0]);
  }
  return part;
}

}  // namespace rigid_body_sim
