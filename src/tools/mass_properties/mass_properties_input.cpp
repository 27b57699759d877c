#include "tools/mass_properties/mass_properties_input.hpp"

#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "programs/tool_scene.hpp"
#include "programs/usage.hpp"
#include "scene/build/body_mass.hpp"
#include "scene/meshes/read_mesh.hpp"
#include "scene/meshes/solid_mesh.hpp"
#include "scene/message_text.hpp"
#include "scene/readers/file_type.hpp"
#include "scene/urdf/read_urdf.hpp"
#include "tools/mass_properties/scene_names.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kDensityOfWater = 1000;

/// The file's name without its extension, made a name that a scene accepts.
std::string nameOf(const std::string& path) {
  return sceneName(std::filesystem::path(path).stem().string(), "mesh_");
}

Masses massOfMesh(const MassPropertiesOptions& options) {
  Masses masses;
  const MeshDef mesh = readSolidMesh(options.file, Vector3d::Constant(options.scale.value_or(1)),
                                     MeshSolid::kSurface, masses.notices);
  const double density = options.density.value_or(kDensityOfWater);
  const MassProperties mass =
      massProperties(SolidDef{mesh, options.mass ? *options.mass : density * mesh.volume});
  const std::string fault = massPropertiesFault(mass);
  if (!fault.empty()) throw std::runtime_error(options.file + ": " + fault);
  std::ostringstream remark;
  remark.precision(10);
  remark << "volume " << mesh.volume << " m^3, density " << mass.mass / mesh.volume << " kg/m^3";
  if (!options.mass && !options.density)
    remark << " (assumed: neither --density nor --mass is given)";
  masses.bodies.push_back({nameOf(options.file), remark.str(), mass});
  return masses;
}

Masses massesOfScene(const std::string& path) {
  const Scene scene = loadToolScene(path);
  Masses masses;
  masses.notices = scene.notices;
  for (const BodyDef& body : scene.bodies) {
    const std::string where = path + ":" + std::to_string(body.composition_line) + ": ";
    if (hasMass(body))
      masses.bodies.push_back({body.name, "", massProperties(body)});
    else
      masses.notices.push_back(where + "body '" + body.name + "': a plane has no mass properties");
  }
  if (masses.bodies.empty()) throw std::runtime_error(masses.notices.back());
  return masses;
}

Masses massesOfUrdf(const std::string& path) {
  const UrdfRobot robot = readUrdf(path);
  Masses masses;
  const std::string where = path + ": ";
  for (const std::string& notice : robot.notices) masses.notices.push_back(where + notice);
  for (const UrdfLink& link : robot.links) {
    if (!link.mass) continue;
    const std::string fault = massPropertiesFault(*link.mass);
    if (fault.empty())
      masses.bodies.push_back({link.name, "", *link.mass});
    else
      masses.faults.push_back(where + ofLink(link.name, fault));
  }
  if (masses.bodies.empty() && masses.faults.empty())
    throw std::runtime_error(where + "no link has an <inertial>");
  return masses;
}

/// Refuses files of types that are well known and not read here. Any other name is a scene's.
void requireSupported(const std::string& path, const std::string& extension) {
  if (!isOfUnsupportedType(extension)) return;
  throw std::runtime_error(path + ": unsupported file type " + extension +
                           "; supported: .stl, .obj, .dae (meshes), .urdf, .xml (URDF), any other "
                           "name (scenes)" +
                           (extension == ".xacro" ? "; xacro makes a .urdf of it" : ""));
}

}  // namespace

Masses readMasses(const MassPropertiesOptions& options) {
  const std::string extension = extensionOf(options.file);
  requireSupported(options.file, extension);
  const bool is_mesh = extension == ".stl" || extension == ".obj" || extension == ".dae";
  const bool is_urdf = extension == ".urdf" || extension == ".xml";
  if (is_mesh) return massOfMesh(options);
  if (options.density || options.mass)
    throw UsageError("--density and --mass go with a mesh; " + options.file +
                     " says what its bodies weigh");
  if (options.scale)
    throw UsageError("--scale goes with a mesh; " + options.file +
                     " says how large its bodies are");
  return is_urdf ? massesOfUrdf(options.file) : massesOfScene(options.file);
}

}  // namespace rigid_body_sim
