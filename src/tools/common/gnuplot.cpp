#include "tools/common/gnuplot.hpp"

#include <cstdio>
#include <cstdlib>
#include <stdexcept>

#include "programs/usage.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {

bool hasGnuplot() { return std::system("command -v gnuplot >/dev/null 2>&1") == 0; }

std::string gnuplotIsMissing(const std::string& there) {
  return "gnuplot is not installed: " + there + ", the plot is not (apt install gnuplot-nox)";
}

std::string pictureDirectory(const std::string& option, const std::string& path) {
  if (path.empty() || oneLine(path) != path)
    throw UsageError("--" + option + ": must be a path without control characters, got '" +
                     printable(path) + "'");
  return path;
}

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
