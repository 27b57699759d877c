#include "ros/bag/open_bag.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include <rosbag/bag.h>

#include "scene/files/read_file.hpp"

namespace rigid_body_sim {
namespace {

constexpr const char* kCut =
    "the bag is cut: its recording has not ended, or was killed; 'rosbag reindex' mends what is "
    "there";

}  // namespace

void openBag(const std::string& path, rosbag::Bag& bag) {
  std::error_code none;
  const std::filesystem::path file(path);
  if (std::filesystem::is_directory(file, none)) throw std::runtime_error("is a directory");
  if (std::filesystem::is_regular_file(file, none) && std::filesystem::file_size(file, none) == 0)
    throw std::runtime_error("the file is empty");
  // rosbag does not say why it cannot open a file
  if (!std::ifstream(file)) throw std::runtime_error(openFault(path, errno));
  try {
    bag.open(path, rosbag::bagmode::Read);
  } catch (const rosbag::BagUnindexedException&) {
    throw std::runtime_error(kCut);
  } catch (const rosbag::BagIOException& fault) {
    const std::string text = fault.what();
    if (text == "Error reading version line")
      throw std::runtime_error("is not a bag: its first line must begin with #ROSBAG");
    const bool ends_early =
        text.rfind("Error reading from", 0) == 0 || text.rfind("Error seek", 0) == 0;
    if (!ends_early) throw;
    throw std::runtime_error(std::string(kCut) + " (" + text + ")");
  }
}

}  // namespace rigid_body_sim
