#include "tools/mass_properties/scene_names.hpp"

#include <algorithm>
#include <set>

#include <rigid_body_sim/scene/scene.hpp>

#include "scene/limits.hpp"

namespace rigid_body_sim {
namespace {

bool isLetter(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

std::string sceneName(const std::string& text, const std::string& prefix) {
  constexpr std::size_t kRoom = 32;  // for the prefix and for what tells names apart
  std::string name = text;
  for (char& c : name)
    if (!isLetter(c) && !isDigit(c)) c = '_';
  const bool stands = !name.empty() && isLetter(name[0]) && name != Scene().world_frame;
  if (stands && name == text && name.size() <= kMaxNameBytes) return name;
  name.resize(std::min(name.size(), kMaxNameBytes - kRoom));
  return stands ? name : prefix + name;
}

std::vector<std::string> sceneNamesOfLinks(const std::vector<std::string>& links) {
  std::vector<std::string> names;
  std::set<std::string> taken(links.begin(), links.end());  // a link keeps a name that is accepted
  for (const std::string& link : links) {
    const std::string name = sceneName(link, "link_");
    std::string free = name;
    for (int k = 2; free != link && !taken.insert(free).second; ++k)
      free = name + "_" + std::to_string(k);
    names.push_back(free);
  }
  return names;
}

}  // namespace rigid_body_sim
