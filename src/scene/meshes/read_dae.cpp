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

Eigen::Affine3d lookAt(const std::vector<double>& n) {
  const Vector3d up = vectorAt(n, 6).normalized();
  const Vector3d ahead = (vectorAt(n, 3) - vectorAt(n, 0)).normalized();
  Eigen::Affine3d X = Eigen::Affine3d::Identity();
  X.linear() << ahead.cross(up).normalized(), up, -ahead;
  X.translation() = vectorAt(n, 0);
  return X;
}

/// What a child of a node does to its place; identity for one that does nothing.
Eigen::Affine3d transformOf(const DaeElement& e) {
  Eigen::Affine3d X = Eigen::Affine3d::Identity();
  if (isNamed(e, "matrix")) {
    const std::vector<double> m = numbersIn(e, 16);  // by rows
    X.affine() = Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(m.data());
  } else if (isNamed(e, "translate")) {
    X.translation() = vectorAt(numbersIn(e, 3), 0);
  } else if (isNamed(e, "scale")) {
    X.linear() = vectorAt(numbersIn(e, 3), 0).asDiagonal();
  } else if (isNamed(e, "rotate")) {
    const std::vector<double> n = numbersIn(e, 4);  // axis, degrees
    const double length = vectorAt(n, 0).norm();
    if (length > 0)
      X.linear() = Eigen::AngleAxisd(n[3] * M_PI / 180, vectorAt(n, 0) / length).toRotationMatrix();
  } else if (isNamed(e, "lookat")) {
    X = lookAt(numbersIn(e, 9));
  } else if (isNamed(e, "skew")) {
    failAt(e, "is not supported: export the mesh with its transforms applied");
  }
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
