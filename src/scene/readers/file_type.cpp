#include "scene/readers/file_type.hpp"

#include <set>

#include <rigid_body_sim/scene/scene_error.hpp>

#include "scene/meshes/read_mesh.hpp"

namespace rigid_body_sim {

bool isOfUnsupportedType(const std::string& extension) {
  static const std::set<std::string> unsupported{
      ".3ds",  ".3mf",  ".amf",  ".blend", ".brep",  ".dxf", ".fbx",  ".glb",
      ".gltf", ".iges", ".igs",  ".off",   ".ply",   ".sdf", ".step", ".stp",
      ".usd",  ".usda", ".usdc", ".usdz",  ".world", ".wrl", ".x3d",  ".xacro"};
  return unsupported.count(extension) > 0;
}

void requireSceneName(const std::string& path) {
  const std::string extension = extensionOf(path);
  const std::string is_text = ", and a scene is YAML text";
  const std::string names_it = is_text + "; a body of it names the file, ";
  if (isOfUnsupportedType(extension))
    throw SceneError(path, 0, "unsupported file type " + extension + is_text);
  if (extension == ".stl" || extension == ".obj" || extension == ".dae")
    throw SceneError(path, 0, "is a mesh by its name" + names_it + "shape: {mesh: {file:}}");
  if (extension == ".urdf" || extension == ".xml")
    throw SceneError(path, 0, "is a URDF file by its name" + names_it + "urdf: {file:}");
}

}  // namespace rigid_body_sim
