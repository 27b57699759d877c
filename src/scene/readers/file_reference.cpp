#include "scene/readers/file_reference.hpp"

#include "scene/files/viewer_url.hpp"

namespace rigid_body_sim {
namespace {

const std::string kPackage = "package://";

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

}  // namespace rigid_body_sim
