#include "scene/urdf/urdf_visual.hpp"

#include <rigid_body_sim/math/isometry.hpp>

#include "scene/files/viewer_url.hpp"

namespace rigid_body_sim {
namespace {

Vector3d toVector3d(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

/// By the class and not by its field `type`, which newer releases of urdfdom extend.
std::optional<UrdfGeometry> toGeometry(const urdf::Geometry* geometry) {
  if (const auto* sphere = dynamic_cast<const urdf::Sphere*>(geometry))
    return Sphere{sphere->radius};
  if (const auto* box = dynamic_cast<const urdf::Box*>(geometry)) return Box{toVector3d(box->dim)};
  if (const auto* cylinder = dynamic_cast<const urdf::Cylinder*>(geometry))
    return Cylinder{cylinder->radius, cylinder->length};
  if (const auto* mesh = dynamic_cast<const urdf::Mesh*>(geometry))
    return UrdfMesh{mesh->filename, toVector3d(mesh->scale)};
  return std::nullopt;
}

}  // namespace

Isometry3d toIsometry(const urdf::Pose& pose) {
  const urdf::Rotation& q = pose.rotation;
  return isometry(Quaterniond(q.w, q.x, q.y, q.z).normalized(), toVector3d(pose.position));
}

std::optional<Visual> toVisual(const urdf::Visual& visual, const std::filesystem::path& directory) {
  const std::optional<UrdfGeometry> geometry = toGeometry(visual.geometry.get());
  if (!geometry) return std::nullopt;
  const auto channel = [](float c) { return static_cast<double>(c); };
  Visual drawn{{}, toIsometry(visual.origin), {}};
  if (const auto* mesh = std::get_if<UrdfMesh>(&*geometry))
    drawn.geometry = MeshVisual{viewerUrl(mesh->file, directory), mesh->scale};
  else
    drawn.geometry = std::get<Shape>(*geometry);
  // a material of a texture alone has a colour that nobody chose
  if (visual.material && visual.material->texture_filename.empty()) {
    const urdf::Color& c = visual.material->color;
    drawn.color = Color{channel(c.r), channel(c.g), channel(c.b), channel(c.a)};
  }
  return drawn;
}

UrdfCollision toCollision(const urdf::Collision& collision) {
  return {toGeometry(collision.geometry.get()), toIsometry(collision.origin)};
}

}  // namespace rigid_body_sim
