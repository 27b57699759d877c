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

/// Notes a file that is for a viewer alone among those that the scene names. url: as viewerUrl; one
/// in a package is not looked for.
void noteDrawnFile(const std::string& url, ReadContext& context);

/// The same that a file in a directory says. Throws std::runtime_error with one line.
FileReference resolvedReference(const std::string& text, const std::filesystem::path& directory,
                                const PackageFinder& find_package);

}  // namespace rigid_body_sim
