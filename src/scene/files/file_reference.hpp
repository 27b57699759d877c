#pragma once

#include <filesystem>
#include <string>

#include "scene/readers/entry.hpp"

namespace rigid_body_sim {

/// A file that a scene names.
struct FileReference {
  std::string path;  ///< absolute
  std::string url;   ///< for a viewer: package:// as in the scene, else file://
};

/// package://<package>/<path>, or a path, which may be relative. Says nothing of whether it exists.
FileReference readFileReference(const Entry& value);

/// The URL of a file that is for a viewer alone: what is a URL already stays as it is; a path that
/// is relative starts from the directory.
std::string viewerUrl(const std::string& reference, const std::filesystem::path& directory);

}  // namespace rigid_body_sim
