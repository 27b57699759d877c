#include "scene/readers/file_reference.hpp"

#include <stdexcept>

#include "scene/files/percent_code.hpp"
#include "scene/files/viewer_url.hpp"

namespace rigid_body_sim {
namespace {

const std::string kPackage = "package://";

/// text: begins with package://
std::string packagePath(const std::string& text, const PackageFinder& find_package) {
  const std::size_t slash = text.find('/', kPackage.size());
  const std::string package =
      text.substr(kPackage.size(), slash == std::string::npos ? slash : slash - kPackage.size());
  if (slash == std::string::npos || package.empty() || slash + 1 == text.size())
    throw std::runtime_error("must be package://<package>/<path> or a path");
  if (!find_package)
    throw std::runtime_error("must be a path: this program cannot look up ROS packages");
  const std::string directory = find_package(package);
  if (directory.empty())
    throw std::runtime_error("must name a ROS package that is on ROS_PACKAGE_PATH");
  return directory + text.substr(slash);
}

}  // namespace

FileReference resolvedReference(const std::string& text, const std::filesystem::path& directory,
                                const PackageFinder& find_package) {
  if (text.compare(0, kPackage.size(), kPackage) == 0)
    return {packagePath(text, find_package), text};
  if (text.find("://") != std::string::npos)
    throw std::runtime_error("must be package://<package>/<path> or a path");
  const std::string path = absolutePath(text, directory);
  return {path, fileUrl(path)};
}

void noteDrawnFile(const std::string& url, ReadContext& context) {
  const std::string scheme = "file://";
  if (url.compare(0, scheme.size(), scheme) != 0) return;
  if (const auto path = percentDecoded(url.substr(scheme.size()))) context.files.insert(*path);
}

FileReference readFileReference(const Entry& value) {
  const std::string text = readText(value);
  try {
    const FileReference file =
        resolvedReference(text, value.context().directory, value.context().find_package);
    value.context().files.insert(file.path);
    return file;
  } catch (const std::runtime_error& rule) {
    value.failRule(rule.what());
  }
}

}  // namespace rigid_body_sim
