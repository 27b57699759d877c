#include "scene/files/file_reference.hpp"

#include <system_error>

namespace rigid_body_sim {
namespace {

const std::string kPackage = "package://";

std::string absolutePath(const std::string& path, const std::filesystem::path& directory) {
  std::error_code no_working_directory;  // then the path stays relative, and is not found
  const auto absolute = std::filesystem::absolute(directory / path, no_working_directory);
  return (no_working_directory ? directory / path : absolute).lexically_normal().string();
}

/// file:// and the path, with every byte that has a meaning in a URL, or none, as %XX.
std::string fileUrl(const std::string& path) {
  constexpr char kHex[] = "0123456789ABCDEF";
  const std::string plain =
      "/ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~+,@";
  std::string url = "file://";
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (plain.find(c) != std::string::npos)
      url += c;
    else
      url += {'%', kHex[byte / 16], kHex[byte % 16]};
  }
  return url;
}

/// text: begins with package://
std::string packagePath(const Entry& value, const std::string& text) {
  const std::size_t slash = text.find('/', kPackage.size());
  const std::string package =
      text.substr(kPackage.size(), slash == std::string::npos ? slash : slash - kPackage.size());
  if (slash == std::string::npos || package.empty() || slash + 1 == text.size())
    value.failRule("must be package://<package>/<path> or a path");
  const PackageFinder& find_package = value.context().find_package;
  if (!find_package) value.failRule("must be a path: this program cannot look up ROS packages");
  const std::string directory = find_package(package);
  if (directory.empty()) value.failRule("must name a ROS package that is on ROS_PACKAGE_PATH");
  return directory + text.substr(slash);
}

}  // namespace

FileReference readFileReference(const Entry& value) {
  const std::string text = readText(value);
  if (text.compare(0, kPackage.size(), kPackage) == 0) return {packagePath(value, text), text};
  if (text.find("://") != std::string::npos)
    value.failRule("must be package://<package>/<path> or a path");
  const std::string path = absolutePath(text, value.context().directory);
  return {path, fileUrl(path)};
}

std::string viewerUrl(const std::string& reference, const std::filesystem::path& directory) {
  if (reference.find("://") != std::string::npos) return reference;
  return fileUrl(absolutePath(reference, directory));
}

}  // namespace rigid_body_sim
