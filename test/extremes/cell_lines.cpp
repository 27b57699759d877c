#include "cell_lines.hpp"

#include <algorithm>
#include <cstdio>

namespace rigid_body_sim::extremes {
namespace {

std::string unquoted(std::string text) {
  std::replace(text.begin(), text.end(), '"', '\'');
  return text;
}

}  // namespace

bool print(const Cells& cells) {
  bool complete = true;
  for (const Cell& c : cells) {
    std::printf("%s,%s,\"%s\",%.2g,%.2g,%.2g,%.2g,\"%s\",\"%s\"\n", c.section.c_str(),
                c.setting.c_str(), c.integrator.c_str(), c.attitude, c.position, c.energy,
                c.angular_momentum, unquoted(c.said).c_str(), unquoted(c.warned).c_str());
    if (!c.said.empty() || (c.finite() && c.section != "refused")) continue;
    std::fprintf(stderr, "empty cell: %s %s %s\n", c.section.c_str(), c.setting.c_str(),
                 c.integrator.c_str());
    complete = false;
  }
  std::fflush(stdout);
  return complete;
}

}  // namespace rigid_body_sim::extremes
