#include "scene/urdf/read_urdf.hpp"

#include <filesystem>
#include <map>
#include <stdexcept>

#include "scene/files/read_file.hpp"
#include "scene/limits.hpp"
#include "scene/message_text.hpp"
#include "scene/urdf/fixed_links.hpp"
#include "scene/urdf/parse_urdf.hpp"
#include "scene/urdf/urdf_visual.hpp"

namespace rigid_body_sim {
namespace {

/// urdfdom destroys a chain of links by a call for each, so that many would exhaust the stack.
void checkLinkCount(const std::string& xml) {
  std::size_t count = 0;
  for (std::size_t at = xml.find("<link"); at != std::string::npos; at = xml.find("<link", at + 1))
    ++count;
  if (count > kMaxLinks)
    throw std::runtime_error("must hold at most " + std::to_string(kMaxLinks) + " links, got " +
                             std::to_string(count));
}

MassProperties toMassProperties(const urdf::Inertial& i) {
  Matrix3d I;
  I << i.ixx, i.ixy, i.ixz,  //
      i.ixy, i.iyy, i.iyz,   //
      i.ixz, i.iyz, i.izz;
  return transformed(toIsometry(i.origin), {i.mass, Vector3d::Zero(), I});
}

UrdfLink toLink(const urdf::Link& link, const std::filesystem::path& directory,
                std::vector<std::string>& notices) {
  UrdfLink read;
  read.name = link.name;
  if (link.inertial) read.mass = toMassProperties(*link.inertial);
  for (const urdf::VisualSharedPtr& visual : link.visual_array) {
    const std::optional<Visual> drawn = toVisual(*visual, directory);
    if (drawn)
      read.visuals.push_back(*drawn);
    else
      notices.push_back(
          ofLink(link.name, "a <visual> without a geometry that is known is left out"));
  }
  for (const urdf::CollisionSharedPtr& collision : link.collision_array)
    read.collisions.push_back(toCollision(*collision));
  return read;
}

void addJoints(const urdf::ModelInterface& model, std::vector<UrdfLink>& links) {
  std::map<std::string, UrdfLink*> by_name;
  for (UrdfLink& link : links) by_name[link.name] = &link;
  for (const auto& [name, joint] : model.joints_) {
    UrdfLink& child = *by_name.at(joint->child_link_name);
    if (!child.parent.empty())
      throw std::runtime_error("the links must form a tree, but '" + printable(child.name) +
                               "' is the child of two joints");
    child.parent = joint->parent_link_name;
    child.fixed = joint->type == urdf::Joint::FIXED;
    child.X_PL = toIsometry(joint->parent_to_joint_origin_transform);
  }
}

/// Links that no way leads to from the root hang on one another in a circle.
void checkTree(const UrdfRobot& robot) {
  UrdfRobot stiff = robot;
  for (UrdfLink& link : stiff.links) link.fixed = !link.parent.empty();
  if (fixedLinks(stiff, robot.root).size() != robot.links.size())
    throw std::runtime_error(
        "the links must form a tree, but some hang on one another in a circle");
}

UrdfRobot toRobot(ParsedUrdf parsed, const std::filesystem::path& directory) {
  UrdfRobot robot;
  robot.notices = std::move(parsed.notices);
  robot.collision_fault = std::move(parsed.looks_fault);
  robot.root = parsed.model->getRoot()->name;
  for (const auto& [name, link] : parsed.model->links_) {
    robot.links.push_back(toLink(*link, directory, robot.notices));
    link->child_links.clear();
  }
  addJoints(*parsed.model, robot.links);
  checkTree(robot);
  return robot;
}

}  // namespace

UrdfRobot readUrdf(const std::string& path) {
  const std::string xml = readFile(path, "URDF file", kMaxUrdfBytes);
  try {
    checkLinkCount(xml);
    return toRobot(parseUrdf(xml), std::filesystem::path(path).parent_path());
  } catch (const std::runtime_error& e) {
    throw std::runtime_error(path + ": is not a URDF file that can be read: " + oneLine(e.what()));
  }
}

std::string ofLink(const std::string& link, const std::string& text) {
  return "link '" + printable(link) + "': " + text;
}

}  // namespace rigid_body_sim
