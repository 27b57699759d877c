#include <algorithm>
#include <stdexcept>

#include "scene/files/file_reference.hpp"
#include "scene/readers/read_urdf.hpp"
#include "scene/readers/readers.hpp"

namespace rigid_body_sim {
namespace {

std::string namesOf(const std::vector<UrdfLink>& links) {
  std::vector<std::string> names;
  names.reserve(links.size());
  for (const UrdfLink& link : links) names.push_back(printable(link.name));
  return nameList(names);
}

}  // namespace

LinkDef readLink(const Entry& entry) {
  struct Named {
    FileReference file;
    std::string link;
  };
  const std::vector<Key<Named>> keys = {
      {"file", [](const Entry& e, Named& n) { n.file = readFileReference(e); }, true},
      {"link", [](const Entry& e, Named& n) { n.link = readText(e); }, true},
  };
  Named named;
  readMapping(entry, keys, named);

  std::vector<UrdfLink> links;
  const Entry file = entry.child(*entry.node().find("file"));
  try {
    links = readUrdf(named.file.path);
  } catch (const std::runtime_error& e) {
    file.fail(file.key() + ": " + e.what());
  }
  const Entry name = entry.child(*entry.node().find("link"));
  const auto link = std::find_if(links.begin(), links.end(),
                                 [&](const UrdfLink& l) { return l.name == named.link; });
  if (link == links.end())
    name.failRule("must be a link of " + named.file.path + " (links: " + namesOf(links) + ")");
  if (!link->mass) name.failRule("must have an <inertial> in " + named.file.path);
  return {*link->mass, link->visuals};
}

}  // namespace rigid_body_sim
