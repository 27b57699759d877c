#include "scene/message_text.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <sstream>

namespace rigid_body_sim {
namespace {

/// How many characters have to be put in, taken out or replaced (Levenshtein).
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> to_prefix(b.size() + 1);  // of what was gone through of a, to those of b
  std::iota(to_prefix.begin(), to_prefix.end(), std::size_t{0});
  for (const char c : a) {
    std::size_t diagonal = to_prefix[0]++;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (c != b[j - 1]);
      diagonal = to_prefix[j];
      to_prefix[j] = std::min({replaced, diagonal + 1, to_prefix[j - 1] + 1});
    }
  }
  return to_prefix[b.size()];
}

/// The name that differs least from the text, by fewer edits than `limit`; null: none does.
const std::string* nearest(const std::string& text, const std::vector<std::string>& names,
                           std::size_t limit) {
  const std::string* found = nullptr;
  for (std::size_t i = 0; i < names.size() && i < kMaxComparedNames; ++i) {
    const auto [shorter, longer] = std::minmax({text.size(), names[i].size()});
    if (longer - shorter >= limit) continue;
    const std::size_t edits = editDistance(text, names[i]);
    if (edits >= limit) continue;
    limit = edits;
    found = &names[i];
  }
  return found;
}

}  // namespace

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

std::string nameList(const std::vector<std::string>& names, std::size_t most) {
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) list += ", ";
    if (i == most) return list + "...";
    list += names[i];
  }
  return list;
}

std::string nearestOf(const std::string& text, const std::vector<std::string>& names) {
  const std::string* found = nearest(text, names, std::numeric_limits<std::size_t>::max());
  return found ? *found : "";
}

std::string didYouMean(const std::string& text, const std::vector<std::string>& names) {
  const std::string* found = nearest(text, names, text.size() <= 3 ? 2 : 3);
  return !found || found->empty() ? "" : "; did you mean '" + printable(*found) + "'?";
}

}  // namespace rigid_body_sim
