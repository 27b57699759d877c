#include "programs/make_directory.hpp"

#include <filesystem>
#include <stdexcept>

#include "scene/message_text.hpp"

namespace rigid_body_sim {

void makeDirectory(const std::string& path) {
  std::error_code fault;
  std::filesystem::create_directories(path, fault);
  std::error_code is_gone;
  if (fault && std::filesystem::is_regular_file(path, is_gone))
    throw std::runtime_error(oneLine(path) + ": is a file, and must be a directory");
  if (fault && std::filesystem::is_symlink(path, is_gone))
    throw std::runtime_error(oneLine(path) + ": is a link that leads to no directory");
  if (fault) throw std::runtime_error(oneLine(path) + ": cannot be created: " + fault.message());
}

}  // namespace rigid_body_sim
