#include "tools/common/gnuplot.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
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

namespace {

/// What gnuplot cannot write it draws on the standard output.
void requireWritable(const std::string& picture) {
  std::FILE* file = std::fopen(picture.c_str(), "ab");
  if (!file) throw std::runtime_error(picture + ": cannot be written: " + std::strerror(errno));
  std::fclose(file);
}

/// Of a disk that is full gnuplot says nothing.
bool isWhole(const std::string& picture) {
  constexpr std::streamoff kTail = 16;
  std::ifstream in(picture, std::ios::binary | std::ios::ate);
  if (!in || in.tellg() < kTail) return false;
  in.seekg(-kTail, std::ios::end);
  std::array<char, kTail> tail{};
  in.read(tail.data(), kTail);
  return std::string(tail.data(), kTail).find("</svg>") != std::string::npos;
}

}  // namespace

void runGnuplot(const std::string& script, const std::string& picture) {
  requireWritable(picture);
  const auto fail = [&](const std::string& message) {
    std::error_code kept;
    // what is not whole is no picture
    if (std::filesystem::is_regular_file(picture, kept)) std::filesystem::remove(picture, kept);
    throw std::runtime_error(message);
  };
  // its warnings are about its script, which the user has not written
  std::FILE* gnuplot = popen("gnuplot 2>/dev/null", "w");
  if (!gnuplot) fail("gnuplot cannot be started");
  std::fputs(script.c_str(), gnuplot);
  if (pclose(gnuplot) != 0) fail("gnuplot could not draw " + picture);
  if (!isWhole(picture))
    fail(picture + ": ends before the end of the picture; is there room on the disk?");
}

std::string gnuplotText(const std::string& text) {
  std::string doubled;
  for (char c : text) doubled += c == '\'' ? "''" : std::string(1, c);
  return "'" + doubled + "'";
}

}  // namespace rigid_body_sim
