#include "scene/meshes/read_dae.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "scene/files/word_reader.hpp"
#include "scene/limits.hpp"
#include "scene/meshes/dae_geometry.hpp"
#include "scene/meshes/mesh_room.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

Vector3d vectorAt(const std::vector<double>& numbers, std::size_t first) {
  return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

/// Rows of a matrix, of which the last must leave the fourth coordinate alone.
Eigen::Affine3d matrixIn(const DaeElement& e) {
  const std::vector<double> m = numbersIn(e, 16);
  if (m[12] != 0 || m[13] != 0 || m[14] != 0 || m[15] != 1)
    failAt(e,
           "must end with 0 0 0 1, the last row of what moves, turns and scales: export the mesh "
           "with its transforms applied");
  Eigen::Affine3d X = Eigen::Affine3d::Identity();
  X.affine() = Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(m.data());
  return X;
}

/// Of an axis and degrees.
Eigen::Affine3d rotateIn(const DaeElement& e) {
  const std::vector<double> n = numbersIn(e, 4);
  if (n[3] == 0) return Eigen::Affine3d::Identity();
  const Vector3d axis = vectorAt(n, 0).stableNormalized();
  if (!(axis.norm() > 0)) failAt(e, "must have an axis other than 0 0 0");
  return Eigen::Affine3d(Eigen::AngleAxisd(n[3] * M_PI / 180, axis));
}

/// Of an eye, a point that it sees and a direction that is upwards, as gluLookAt has them: what is
/// seen lies along -z, and up in the half-plane of y.
Eigen::Affine3d lookAtIn(const DaeElement& e) {
  constexpr double kLeastAngle = 1e-6;  // below, the last of six digits says what is right
  const std::vector<double> n = numbersIn(e, 9);
  const Vector3d ahead = (vectorAt(n, 3) - vectorAt(n, 0)).stableNormalized();
  const Vector3d right = ahead.cross(vectorAt(n, 6).stableNormalized());
  if (!(right.norm() > kLeastAngle))
    failAt(e,
           "must be a point, another point that is seen from it, and a direction upwards that is "
           "not along the line of sight");
  const Vector3d side = right.normalized();
  Eigen::Affine3d X = Eigen::Affine3d::Identity();
  X.linear() << side, side.cross(ahead), -ahead;
  X.translation() = vectorAt(n, 0);
  return X;
}

/// What a child of a node does to its place; identity for one that does nothing.
Eigen::Affine3d transformOf(const DaeElement& e) {
  Eigen::Affine3d X = Eigen::Affine3d::Identity();
  if (isNamed(e, "matrix")) return matrixIn(e);
  if (isNamed(e, "rotate")) return rotateIn(e);
  if (isNamed(e, "lookat")) return lookAtIn(e);
  if (isNamed(e, "translate"))
    X.translation() = vectorAt(numbersIn(e, 3), 0);
  else if (isNamed(e, "scale"))
    X.linear() = vectorAt(numbersIn(e, 3), 0).asDiagonal();
  else if (isNamed(e, "skew"))
    failAt(e, "is not supported: export the mesh with its transforms applied");
  return X;
}

class SceneReader {
 public:
  explicit SceneReader(const DaeDocument& document) : document_(document) {}

  FileMesh read() {
    const DaeElement& root = document_.root();
    const DaeElement& instance =
        requiredChild(requiredChild(root, "scene"), "instance_visual_scene");
    const DaeElement& scene = document_.referred(instance, "url", "visual_scene");
    readChildren(scene, Eigen::Affine3d(Eigen::Scaling(metresPerUnit(root))), 0);
    return std::move(read_);
  }

 private:
  static double metresPerUnit(const DaeElement& root) {
    const DaeElement* const asset = root.FirstChildElement("asset");
    const DaeElement* const unit = asset ? asset->FirstChildElement("unit") : nullptr;
    double metres = 1;
    if (!unit || !unit->Attribute("meter")) return metres;
    const std::string text = unit->Attribute("meter");
    WordReader words(text, unit->GetLineNum());
    metres = words.number(words.word());
    if (!(metres > 0) || !std::isfinite(metres) || !words.word().empty())
      failAt(*unit, "meter must be one number > 0, got '" + printable(text) + "'");
    return metres;
  }

  void readNode(const DaeElement& node, const Eigen::Affine3d& X_parent, std::size_t depth) {
    if (depth > kMaxXmlDepth)
      failAt(node, "must lie within at most " + std::to_string(kMaxXmlDepth) +
                       " nodes, and not within itself");
    if (++nodes_ > kMaxDaeNodes)
      failAt(node, "must be one of at most " + std::to_string(kMaxDaeNodes) +
                       " nodes, instances counted");
    Eigen::Affine3d X = X_parent;
    for (const auto* e = node.FirstChildElement(); e; e = e->NextSiblingElement())
      X = X * transformOf(*e);
    readChildren(node, X, depth);
  }

  void readChildren(const DaeElement& node, const Eigen::Affine3d& X, std::size_t depth) {
    for (const auto* e = node.FirstChildElement(); e; e = e->NextSiblingElement()) {
      if (isNamed(*e, "node"))
        readNode(*e, X, depth + 1);
      else if (isNamed(*e, "instance_node"))
        readNode(document_.referred(*e, "url", "node"), X, depth + 1);
      else if (isNamed(*e, "instance_geometry"))
        append(geometryOf(document_.referred(*e, "url", "geometry")), X);
      else if (isNamed(*e, "instance_controller"))
        append(geometryOf(skinned(document_.referred(*e, "url", "controller"), 0)), X);
    }
  }

  /// The geometry that a controller bends, which another controller may have bent.
  const DaeElement& skinned(const DaeElement& controller, std::size_t depth) const {
    const DaeElement* bend = controller.FirstChildElement("skin");
    if (!bend) bend = &requiredChild(controller, "morph");
    const DaeElement& source = document_.referred(*bend, "source");
    if (depth < kMaxXmlDepth && isNamed(source, "controller")) return skinned(source, depth + 1);
    return document_.referred(*bend, "source", "geometry");
  }

  /// Read once, however many instances it has.
  const DaeGeometry& geometryOf(const DaeElement& geometry) {
    const auto known = geometries_.find(&geometry);
    if (known != geometries_.end()) return known->second;
    return geometries_.emplace(&geometry, readDaeGeometry(document_, geometry)).first->second;
  }

  /// Appends triangles placed by X; where X mirrors, each is turned round, for it would come out
  /// facing inwards.
  void append(const DaeGeometry& part, const Eigen::Affine3d& X) {
    TriangleMesh& mesh = read_.mesh;
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    const bool mirrored = X.linear().determinant() < 0;
    for (Triangle t : part.mesh.triangles) {
      requireRoom(mesh);
      for (std::uint32_t& corner : t) corner += first;
      if (mirrored) std::swap(t[1], t[2]);
      mesh.triangles.push_back(t);
    }
    for (const Vector3d& v : part.mesh.vertices) mesh.vertices.push_back(X * v);
    const Vector3d rounding = part.rounding * X.linear().cwiseAbs().rowwise().sum();
    read_.rounding = read_.rounding.cwiseMax(rounding);
  }

  const DaeDocument& document_;
  FileMesh read_;
  std::size_t nodes_ = 0;
  std::map<const DaeElement*, DaeGeometry> geometries_;
};

}  // namespace

FileMesh readDae(const std::string& xml) {
  const DaeDocument document(xml);
  return SceneReader(document).read();
}

}  // namespace rigid_body_sim
