#include "tools/sweep/scene_files.hpp"

#include <algorithm>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <variant>

#include <rigid_body_sim/scene/scene_error.hpp>

#include "scene/files/read_file.hpp"
#include "scene/limits.hpp"
#include "scene/readers/file_reference.hpp"
#include "tools/sweep/sweep_info.hpp"

namespace rigid_body_sim {
namespace {

namespace fs = std::filesystem;

/// By the name, then by the directory that it is in, and so on: what two hosts have in common.
struct ByEnds {
  bool operator()(const fs::path& a, const fs::path& b) const {
    const std::vector<fs::path> x(a.begin(), a.end()), y(b.begin(), b.end());
    return std::lexicographical_compare(x.rbegin(), x.rend(), y.rbegin(), y.rend());
  }
};

using Files = std::set<fs::path, ByEnds>;

void addCollisionMeshes(const fs::path& urdf, const UrdfRobot& robot, const PackageFinder& finder,
                        Files& files) {
  for (const UrdfLink& link : robot.links)
    for (const UrdfCollision& collision : link.collisions) {
      const auto* mesh = collision.geometry ? std::get_if<UrdfMesh>(&*collision.geometry) : nullptr;
      if (!mesh) continue;
      try {
        files.insert(resolvedReference(mesh->file, urdf.parent_path(), finder).path);
      } catch (const std::runtime_error&) {  // of a link that no run has: it would be refused
      }
    }
}

Files filesOf(const ReadContext& context) {
  Files files;
  for (const auto& mesh : context.meshes) files.insert(std::get<0>(mesh.first));
  for (const auto& mesh : context.corners) files.insert(std::get<0>(mesh.first));
  for (const auto& [path, robot] : context.robots) {
    files.insert(path);
    if (context.has_contact) addCollisionMeshes(path, robot, context.find_package, files);
  }
  return files;
}

}  // namespace

std::vector<std::string> digestsOfFiles(const ReadContext& context) {
  static_assert(kMaxMeshBytes >= kMaxDaeBytes && kMaxMeshBytes >= kMaxUrdfBytes);
  std::vector<std::string> digests;
  for (const fs::path& file : filesOf(context)) {
    try {
      digests.push_back(std::to_string(digestOf({readFile(file.string(), "file", kMaxMeshBytes)})));
    } catch (const SceneError&) {
      digests.push_back("none");
    }
  }
  return digests;
}

}  // namespace rigid_body_sim
