#include <rigid_body_sim/mass/triangle_mesh.hpp>

#include "math/compensated_sum.hpp"

namespace rigid_body_sim {
namespace {

using Vector4d = Eigen::Vector4d;
using Vector6d = Eigen::Matrix<double, 6, 1>;

Vector3d middle(const std::vector<Vector3d>& vertices) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& v : vertices) box.extend(v);
  return box.center();
}

/// A triangle's corners from the reference point, and six times the signed volume between them.
/// Height times base, both from differences: of a sliver of a far mesh the plain triple product
/// would be left with rounding only.
struct Tetrahedron {
  Vector3d a, b, c;
  double six_volumes;
};
Tetrahedron tetrahedron(const TriangleMesh& mesh, const Triangle& t, const Vector3d& reference) {
  const Vector3d a = mesh.vertices[t[0]] - reference;
  const Vector3d b = mesh.vertices[t[1]] - reference;
  const Vector3d c = mesh.vertices[t[2]] - reference;
  return {a, b, c, a.dot((b - a).cross(c - a))};
}

struct VolumeAndCentroid {
  double volume;      ///< [m³]
  Vector3d centroid;  ///< [m]
};
VolumeAndCentroid volumeAndCentroid(const TriangleMesh& mesh) {
  const Vector3d reference = middle(mesh.vertices);
  CompensatedSum<Vector4d> sum(Vector4d::Zero());  // 6 ∫ dV, 24 ∫ r dV
  for (const Triangle& triangle : mesh.triangles) {
    const auto [a, b, c, d] = tetrahedron(mesh, triangle, reference);
    Vector4d term;
    term << d, d * (a + b + c);
    sum.add(term);
  }
  const Vector4d integrals = sum.value();
  return {integrals[0] / 6, reference + integrals.tail<3>() / (4 * integrals[0])};
}

/// ∫ r rᵀ dV [m⁵] about the reference point: xx, yy, zz, xy, yz, zx.
Vector6d secondMoments(const TriangleMesh& mesh, const Vector3d& reference) {
  CompensatedSum<Vector6d> sum(Vector6d::Zero());
  for (const Triangle& triangle : mesh.triangles) {
    const auto [a, b, c, d] = tetrahedron(mesh, triangle, reference);
    // C++17 has no capture of structured bindings by reference
    const auto moment = [&a = a, &b = b, &c = c, d = d, s = Vector3d(a + b + c)](int i, int j) {
      return d * (a[i] * a[j] + b[i] * b[j] + c[i] * c[j] + s[i] * s[j]);
    };
    Vector6d term;
    term << moment(0, 0), moment(1, 1), moment(2, 2), moment(0, 1), moment(1, 2), moment(2, 0);
    sum.add(term);
  }
  return sum.value() / 120;
}

}  // namespace

double volume(const TriangleMesh& mesh) { return volumeAndCentroid(mesh).volume; }

MassProperties massProperties(const TriangleMesh& mesh, double mass) {
  const auto [volume, centroid] = volumeAndCentroid(mesh);
  const Vector6d m = mass / volume * secondMoments(mesh, centroid);
  MassProperties properties;
  properties.mass = mass;
  properties.com_B = centroid;
  properties.I_Bcm << m[1] + m[2], -m[3], -m[5],  //
      -m[3], m[2] + m[0], -m[4],                  //
      -m[5], -m[4], m[0] + m[1];
  return properties;
}

}  // namespace rigid_body_sim
