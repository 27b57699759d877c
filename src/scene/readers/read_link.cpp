#include <algorithm>
#include <stdexcept>

#include <rigid_body_sim/math/isometry.hpp>

#include "scene/build/inertia_rules.hpp"
#include "scene/readers/file_reference.hpp"
#include "scene/readers/link_collision.hpp"
#include "scene/readers/readers.hpp"
#include "scene/urdf/fixed_links.hpp"

namespace rigid_body_sim {
namespace {

struct LinkKeys {
  FileReference file;
  std::string link;  ///< empty: the root
  bool fixed_joints = true;
};

LinkKeys readLinkKeys(const Entry& entry) {
  static const std::vector<Key<LinkKeys>> keys = {
      {"file", [](const Entry& e, LinkKeys& k) { k.file = readFileReference(e); }, true},
      {"link", [](const Entry& e, LinkKeys& k) { k.link = readText(e); }},
      {"fixed_joints", [](const Entry& e, LinkKeys& k) { k.fixed_joints = readBoolean(e); }},
  };
  LinkKeys read;
  readMapping(entry, keys, read);
  return read;
}

/// The robot of the file that an entry names; a file that several bodies name is read once.
const UrdfRobot& robotOf(const Entry& file, const std::string& path) {
  ReadContext& context = file.context();
  const auto known = context.robots.find(path);
  if (known != context.robots.end()) return known->second;
  try {
    UrdfRobot robot = readUrdf(path);
    const std::string where = path + ": ";
    for (const std::string& notice : robot.notices) file.note(where + notice);
    return context.robots[path] = std::move(robot);
  } catch (const std::runtime_error& e) {
    file.fail(file.key() + ": " + e.what());
  }
}

/// The links that the body is made of.
std::vector<PlacedLink> linksOf(const Entry& entry, const LinkKeys& keys, const UrdfRobot& robot) {
  std::vector<PlacedLink> links = fixedLinks(robot, keys.link.empty() ? robot.root : keys.link);
  if (links.empty()) {
    std::vector<std::string> names;
    for (const UrdfLink& link : robot.links) names.push_back(printable(link.name));
    const Entry name = entry.child(*entry.node().find("link"));
    name.failRule("must be a link of " + keys.file.path + " (links: " + nameList(names) + ")");
  }
  if (!keys.fixed_joints) links.erase(links.begin() + 1, links.end());
  return links;
}

/// The masses of the links, in the body frame.
std::vector<MassProperties> massesOf(const Entry& entry, const std::vector<PlacedLink>& links,
                                     bool balance) {
  std::vector<MassProperties> masses;
  for (const PlacedLink& placed : links) {
    if (!placed.link->mass) continue;
    MassProperties mass = *placed.link->mass;
    const std::string notice = balance ? balanceInertia(mass) : "";
    if (!notice.empty()) entry.note(ofLink(placed.link->name, notice));
    // of a body of one link, checkScene says the same
    const std::string fault = links.size() > 1 ? partMassFault(mass) : "";
    if (!fault.empty()) entry.fail(entry.key() + ": " + ofLink(placed.link->name, fault));
    masses.push_back(transformed(placed.X_BL, mass));
  }
  return masses;
}

[[noreturn]] void failMassless(const Entry& entry, const LinkKeys& keys,
                               const std::vector<PlacedLink>& links) {
  const YamlNode* name = entry.node().find("link");
  const std::string joined = links.size() > 1 ? ", itself or a link fixed to it," : "";
  if (name)
    entry.child(*name).failRule("must have an <inertial>" + joined + " in " + keys.file.path);
  entry.fail(entry.key() + ": the root '" + printable(links.front().link->name) +
             "' must have an <inertial>" + joined + " in " + keys.file.path);
}

/// The links as frames of the body.
std::vector<PointDef> pointsOf(const Entry& entry, const std::vector<PlacedLink>& links) {
  std::vector<PointDef> points;
  for (const PlacedLink& placed : links) {
    const std::string& name = placed.link->name;
    if (isFrameName(name))
      points.push_back({name, placed.X_BL.translation(), Quaterniond(placed.X_BL.linear()),
                        entry.node().line()});
    else
      entry.note("link '" + printable(name) + "' becomes no frame: its name " + frameNameRule());
  }
  return points;
}

}  // namespace

LinkedBody readLink(const Entry& entry, const LinkChoice& choice) {
  const LinkKeys keys = readLinkKeys(entry);
  const UrdfRobot& robot = robotOf(entry.child(*entry.node().find("file")), keys.file.path);
  const std::vector<PlacedLink> links = linksOf(entry, keys, robot);
  const std::vector<MassProperties> masses = massesOf(entry, links, choice.balance);
  if (masses.empty()) failMassless(entry, keys, links);

  LinkedBody body;
  if (choice.touches) body.def.collision = collisionOf(entry, robot, keys.file.path, links);
  body.def.mass = masses.size() == 1 ? masses.front() : combined(masses);
  for (const PlacedLink& placed : links)
    for (Visual visual : placed.link->visuals) {
      visual.X_BV = placed.X_BL * visual.X_BV;
      if (const auto* mesh = std::get_if<MeshVisual>(&visual.geometry))
        noteDrawnFile(mesh->url, entry.context());
      body.def.visuals.push_back(visual);
    }
  if (links.size() > 1) body.points = pointsOf(entry, links);
  return body;
}

}  // namespace rigid_body_sim
