#include "scene/readers/link_collision.hpp"

#include <filesystem>
#include <stdexcept>

#include "scene/readers/file_reference.hpp"
#include "scene/readers/readers.hpp"

namespace rigid_body_sim {
namespace {

void requireLengths(const Vector3d& lengths) {
  if (!(lengths.allFinite() && (lengths.array() > 0).all()))
    throw std::runtime_error("its lengths must be finite and > 0 m, got " + listed(lengths));
}

/// Of the shapes that URDF has.
void requireSize(const Shape& shape) {
  if (const auto* box = std::get_if<Box>(&shape)) requireLengths(box->size);
  if (const auto* sphere = std::get_if<Sphere>(&shape))
    requireLengths(Vector3d::Constant(sphere->radius));
  if (const auto* cylinder = std::get_if<Cylinder>(&shape))
    requireLengths({cylinder->radius, cylinder->radius, cylinder->length});
}

HullDef hullOf(const UrdfMesh& mesh, const std::filesystem::path& directory, ReadContext& context) {
  if (!mesh.scale.allFinite() || (mesh.scale.array() == 0).any())
    throw std::runtime_error("its scale must be three numbers other than 0, got " +
                             listed(mesh.scale));
  try {
    const FileReference file = resolvedReference(mesh.file, directory, context.find_package);
    context.files.insert(file.path);
    return {file.url, mesh.scale, cornersOf(context, file.path, mesh.scale, MeshSolid::kHull)};
  } catch (const std::runtime_error& e) {
    throw std::runtime_error("mesh '" + printable(mesh.file) + "': " + e.what());
  }
}

CollisionDef toDef(const UrdfCollision& collision, const Isometry3d& X_BL,
                   const std::filesystem::path& directory, ReadContext& context) {
  if (!collision.geometry) throw std::runtime_error("its geometry is of a kind that is not known");
  CollisionDef def;
  if (const auto* mesh = std::get_if<UrdfMesh>(&*collision.geometry)) {
    def.geometry = hullOf(*mesh, directory, context);
  } else {
    def.geometry = std::get<Shape>(*collision.geometry);
    requireSize(std::get<Shape>(def.geometry));
  }
  const Isometry3d X_BC = X_BL * collision.X_LC;
  if (!X_BC.matrix().allFinite()) throw std::runtime_error("its origin must be finite");
  def.position = X_BC.translation();
  def.orientation = Quaterniond(X_BC.linear());
  return def;
}

}  // namespace

std::vector<CollisionDef> collisionOf(const Entry& entry, const UrdfRobot& robot,
                                      const std::string& path,
                                      const std::vector<PlacedLink>& links) {
  constexpr char kRemedy[] = " (a scene may say what touches: collision, a key of the body)";
  if (!robot.collision_fault.empty())
    entry.fail(entry.key() + ": " + path + ": <collision> or <visual> elements cannot be read: " +
               robot.collision_fault + kRemedy);
  std::vector<CollisionDef> defs;
  for (const PlacedLink& placed : links)
    for (const UrdfCollision& collision : placed.link->collisions) {
      try {
        defs.push_back(toDef(collision, placed.X_BL, std::filesystem::path(path).parent_path(),
                             entry.context()));
      } catch (const std::runtime_error& e) {
        entry.fail(entry.key() + ": " + path + ": " +
                   ofLink(placed.link->name, std::string("<collision>: ") + e.what() + kRemedy));
      }
    }
  return defs;
}

}  // namespace rigid_body_sim
