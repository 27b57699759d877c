#include "scene/files/write_file.hpp"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string>

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

/// In the same directory, so that it can take the place of the file at once. Nothing lies there
/// yet, nor leads a link from there.
std::string unfinished(const std::string& target) {
  const std::string usual = target + ".unfinished";
  std::string path = usual;
  std::error_code none;
  for (int k = 1; fs::exists(fs::symlink_status(path, none)); ++k)
    path = usual + "." + std::to_string(k);
  return path;
}

std::error_code writeThrough(const std::string& path, const std::string& text) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  if (file) return {};
  return {errno == 0 ? EIO : errno, std::generic_category()};
}

/// Nothing is left of what cannot be written whole.
std::error_code writeWhole(const std::string& path, const std::string& text) {
  const std::error_code fault = writeThrough(path, text);
  std::error_code is_gone;
  if (fault) fs::remove(path, is_gone);
  return fault;
}

}  // namespace

std::error_code writeFile(const std::string& path, const std::string& text) {
  if (isWrittenThrough(path)) return writeThrough(path, text);
  const std::string target = targetOf(path), beside = unfinished(target);
  std::error_code fault = writeWhole(beside, text), is_gone;
  if (fault) return fault;
  fs::rename(beside, target, fault);
  if (fault) fs::remove(beside, is_gone);
  return fault;
}

std::error_code writeFault(const std::string& path) {
  if (isWrittenThrough(path)) return {};
  const std::string beside = unfinished(targetOf(path));
  std::error_code fault = writeWhole(beside, "");
  if (!fault) fs::remove(beside, fault);
  return fault;
}

}  // namespace rigid_body_sim
