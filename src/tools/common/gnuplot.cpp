#include "tools/common/gnuplot.hpp"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace rigid_body_sim {

bool hasGnuplot() { return std::system("command -v gnuplot >/dev/null 2>&1") == 0; }

void runGnuplot(const std::string& script, const std::string& picture) {
  std::FILE* gnuplot = popen("gnuplot", "w");
  if (!gnuplot) throw std::runtime_error("gnuplot cannot be started");
  std::fputs(script.c_str(), gnuplot);
  if (pclose(gnuplot) != 0) throw std::runtime_error("gnuplot could not draw " + picture);
}

std::string gnuplotText(const std::string& text) {
  std::string doubled;
  for (char c : text) doubled += c == '\'' ? "''" : std::string(1, c);
  return "'" + doubled + "'";
}

}  // namespace rigid_body_sim
