#include "scene/message_text.hpp"

#include <algorithm>
#include <sstream>

namespace rigid_body_sim {

std::string oneLine(std::string text) {
  const auto isControl = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  std::replace_if(text.begin(), text.end(), isControl, '?');
  return text;
}

std::string printable(const std::string& text) {
  constexpr std::size_t kMaxLength = 60;
  const std::string line = oneLine(text.substr(0, kMaxLength));
  return text.size() > kMaxLength ? line + "..." : line;
}

std::string listed(const Vector3d& v) {
  std::ostringstream text;
  text << "[" << v.x() << ", " << v.y() << ", " << v.z() << "]";
  return text.str();
}

std::string nameList(const std::vector<std::string>& names) {
  constexpr std::size_t kMaxNames = 10;
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) list += ", ";
    if (i == kMaxNames) return list + "...";
    list += names[i];
  }
  return list;
}

}  // namespace rigid_body_sim
