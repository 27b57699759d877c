#include "scene/readers/read_urdf.hpp"

#include <filesystem>
#include <stdexcept>

#include <console_bridge/console.h>
#include <urdf_parser/urdf_parser.h>

#include <rigid_body_sim/math/isometry.hpp>

#include "scene/files/file_reference.hpp"
#include "scene/files/read_file.hpp"
#include "scene/files/xml_fault.hpp"
#include "scene/limits.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

/// Keeps what the parser has to say from the console while this lives.
class ParserMessages final : public console_bridge::OutputHandler {
 public:
  ParserMessages() : before_(console_bridge::getOutputHandler()) {
    console_bridge::useOutputHandler(this);
  }
  ~ParserMessages() override { console_bridge::useOutputHandler(before_); }
  ParserMessages(const ParserMessages&) = delete;
  ParserMessages& operator=(const ParserMessages&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char* /*source_file*/,
           int /*source_line*/) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR && first_error_.empty())
      first_error_ = text;
  }

  /// Empty where there was none. Those after it say no more than that an element failed for it.
  const std::string& firstError() const { return first_error_; }

 private:
  console_bridge::OutputHandler* before_;
  std::string first_error_;
};

Vector3d toVector3d(const urdf::Vector3& v) { return {v.x, v.y, v.z}; }

Isometry3d toIsometry(const urdf::Pose& pose) {
  const urdf::Rotation& q = pose.rotation;
  return isometry(Quaterniond(q.w, q.x, q.y, q.z).normalized(), toVector3d(pose.position));
}

MassProperties toMassProperties(const urdf::Inertial& i) {
  Matrix3d I;
  I << i.ixx, i.ixy, i.ixz,  //
      i.ixy, i.iyy, i.iyz,   //
      i.ixz, i.iyz, i.izz;
  return transformed(toIsometry(i.origin), {i.mass, Vector3d::Zero(), I});
}

std::variant<Shape, MeshVisual> toGeometry(const urdf::Geometry& geometry,
                                           const std::filesystem::path& directory) {
  switch (geometry.type) {
    case urdf::Geometry::SPHERE:
      return Sphere{dynamic_cast<const urdf::Sphere&>(geometry).radius};
    case urdf::Geometry::BOX:
      return Box{toVector3d(dynamic_cast<const urdf::Box&>(geometry).dim)};
    case urdf::Geometry::CYLINDER: {
      const auto& cylinder = dynamic_cast<const urdf::Cylinder&>(geometry);
      return Cylinder{cylinder.radius, cylinder.length};
    }
    case urdf::Geometry::MESH:
      break;
  }
  const auto& mesh = dynamic_cast<const urdf::Mesh&>(geometry);
  return MeshVisual{viewerUrl(mesh.filename, directory), toVector3d(mesh.scale)};
}

Visual toVisual(const urdf::Visual& visual, const std::filesystem::path& directory) {
  const auto channel = [](float c) { return static_cast<double>(c); };
  Visual drawn{toGeometry(*visual.geometry, directory), toIsometry(visual.origin), {}};
  // a material of a texture alone has a colour that nobody chose
  if (visual.material && visual.material->texture_filename.empty()) {
    const urdf::Color& c = visual.material->color;
    drawn.color = Color{channel(c.r), channel(c.g), channel(c.b), channel(c.a)};
  }
  return drawn;
}

}  // namespace

std::vector<UrdfLink> readUrdf(const std::string& path) {
  const std::string xml = readFile(path, "URDF file", kMostUrdfBytes);
  const ParserMessages messages;
  urdf::ModelInterfaceSharedPtr model;
  std::string reason = xmlFault(xml);
  try {
    if (reason.empty()) {
      model = urdf::parseURDF(xml);
      reason = messages.firstError();
      if (!model && reason.empty()) reason = "not the XML of a robot";
    }
  } catch (const std::exception& e) {
    reason = e.what();
  }
  // the parser goes on after some errors, with zeros in place of what it could not read
  if (!reason.empty())
    throw std::runtime_error(path + ": is not a URDF file that can be read: " + oneLine(reason));

  const std::filesystem::path directory = std::filesystem::path(path).parent_path();
  std::vector<UrdfLink> links;
  for (const auto& [name, link] : model->links_) {
    UrdfLink read{name, std::nullopt, {}};
    if (link->inertial) read.mass = toMassProperties(*link->inertial);
    for (const urdf::VisualSharedPtr& visual : link->visual_array)
      if (visual->geometry) read.visuals.push_back(toVisual(*visual, directory));
    links.push_back(std::move(read));
  }
  return links;
}

}  // namespace rigid_body_sim
