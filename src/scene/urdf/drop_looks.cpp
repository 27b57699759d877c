#include "scene/urdf/drop_looks.hpp"

#include <set>
#include <sstream>

#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

using tinyxml2::XMLElement;

std::string attribute(const XMLElement& element, const char* name) {
  const char* value = element.Attribute(name);
  return value ? value : "";
}

/// Whether the text is four numbers from 0 to 1.
bool isColor(const std::string& rgba) {
  std::istringstream words(rgba);
  std::string word;
  int count = 0;
  for (; words >> word; ++count) {
    std::istringstream number(word);
    number.imbue(std::locale::classic());
    double channel = -1;
    if (!(number >> channel) || number.peek() != EOF || !(channel >= 0 && channel <= 1))
      return false;
  }
  return count == 4;
}

/// Empty for a material that can be used.
std::string materialFault(const XMLElement& material) {
  const XMLElement* color = material.FirstChildElement("color");
  if (!color) return "";
  const std::string rgba = attribute(*color, "rgba");
  if (isColor(rgba)) return "";
  return "its color must be four numbers from 0 to 1, got '" + printable(rgba) + "'";
}

void dropBadMaterialsOf(XMLElement& parent, std::set<std::string>& defined,
                        std::vector<std::string>& notices) {
  for (XMLElement *material = parent.FirstChildElement("material"), *next = nullptr; material;
       material = next) {
    next = material->NextSiblingElement("material");
    const std::string name = attribute(*material, "name");
    std::string fault = materialFault(*material);
    if (fault.empty() && !defined.insert(name).second) fault = "it is defined before";
    if (fault.empty()) continue;
    notices.push_back("material '" + printable(name) + "' is left out: " + fault);
    parent.DeleteChild(material);
  }
}

}  // namespace

std::vector<std::string> dropBadMaterials(tinyxml2::XMLDocument& document) {
  std::vector<std::string> notices;
  XMLElement* robot = document.RootElement();
  if (!robot) return notices;
  std::set<std::string> global;
  dropBadMaterialsOf(*robot, global, notices);
  for (XMLElement* link = robot->FirstChildElement("link"); link;
       link = link->NextSiblingElement("link"))
    for (XMLElement* visual = link->FirstChildElement("visual"); visual;
         visual = visual->NextSiblingElement("visual")) {
      std::set<std::string> local;
      dropBadMaterialsOf(*visual, local, notices);
    }
  return notices;
}

void dropVisuals(tinyxml2::XMLDocument& document) {
  const auto drop = [](XMLElement& parent, const char* name) {
    while (XMLElement* child = parent.FirstChildElement(name)) parent.DeleteChild(child);
  };
  XMLElement* robot = document.RootElement();
  if (!robot) return;
  drop(*robot, "material");
  for (XMLElement* link = robot->FirstChildElement("link"); link;
       link = link->NextSiblingElement("link")) {
    drop(*link, "visual");
    drop(*link, "collision");
  }
}

}  // namespace rigid_body_sim
