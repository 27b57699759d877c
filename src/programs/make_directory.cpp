#include "programs/make_directory.hpp"

#include <filesystem>
#include <stdexcept>

#include "scene/message_text.hpp"

namespace rigid_body_sim {

void makeDirectory(const std::string& path) {
  std::error_code fault;
  std::filesystem::create_directories(path, fault);
  if (fault) throw std::runtime_error(oneLine(path) + ": cannot be created: " + fault.message());
}

}  // namespace rigid_body_sim
