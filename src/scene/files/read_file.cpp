#include "scene/files/read_file.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include <rigid_body_sim/scene/scene_error.hpp>

namespace rigid_body_sim {

std::string lookedForIn(const std::string& path) {
  std::error_code unknown;
  const std::filesystem::path directory = std::filesystem::current_path(unknown);
  if (unknown || std::filesystem::path(path).is_absolute()) return "";
  return " (looked for in " + directory.string() + ")";
}

std::string openFault(const std::string& path, int reason) {
  return std::string("cannot be opened: ") + std::strerror(reason) + lookedForIn(path);
}

std::string readFile(const std::string& path, const std::string& kind, std::size_t most_bytes) {
  std::error_code no_matter;  // what cannot be looked at cannot be opened either
  if (std::filesystem::is_directory(path, no_matter))
    throw SceneError(path, 0, "is a directory, not a " + kind);
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw SceneError(path, 0, openFault(path, errno));
  std::string text;
  std::array<char, 1 << 16> block;
  while (text.size() <= most_bytes && file) {
    file.read(block.data(), block.size());
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) throw SceneError(path, 0, std::string("cannot be read: ") + std::strerror(errno));
  if (text.size() > most_bytes)
    throw SceneError(path, 0, "is larger than " + std::to_string(most_bytes >> 20) + " MiB");
  return text;
}

}  // namespace rigid_body_sim
