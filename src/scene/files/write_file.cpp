#include "scene/files/write_file.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>

namespace rigid_body_sim {
namespace {

namespace fs = std::filesystem;

/// Whether nothing can take its place.
bool isWrittenThrough(const std::string& path) {
  std::error_code is_gone;
  const fs::file_status there = fs::status(path, is_gone);
  return fs::exists(there) && !fs::is_regular_file(there);
}

/// That to which links lead.
std::string targetOf(const std::string& path) {
  std::error_code fault;
  const std::string target = fs::canonical(path, fault).string();
  return fault ? path : target;
}

/// In the same directory, so that it can take the place of the file at once.
std::string unfinished(const std::string& target) { return target + ".unfinished"; }

std::error_code writeThrough(const std::string& path, const std::string& text) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (file) return {};
  return {errno == 0 ? EIO : errno, std::generic_category()};
}

/// A link or a pipe there, which would be written through, is replaced, too.
std::error_code writeBeside(const std::string& target, const std::string& text) {
  std::error_code fault, is_gone;
  fs::remove(unfinished(target), fault);
  if (!fault) fault = writeThrough(unfinished(target), text);
  if (fault) fs::remove(unfinished(target), is_gone);
  return fault;
}

}  // namespace

std::error_code writeFile(const std::string& path, const std::string& text) {
  if (isWrittenThrough(path)) return writeThrough(path, text);
  const std::string target = targetOf(path);
  std::error_code fault = writeBeside(target, text), is_gone;
  if (fault) return fault;
  fs::rename(unfinished(target), target, fault);
  if (fault) fs::remove(unfinished(target), is_gone);
  return fault;
}

std::error_code writeFault(const std::string& path) {
  if (isWrittenThrough(path)) return {};
  const std::string target = targetOf(path);
  std::error_code fault = writeBeside(target, "");
  if (!fault) fs::remove(unfinished(target), fault);
  return fault;
}

}  // namespace rigid_body_sim
