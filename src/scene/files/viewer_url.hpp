#pragma once

#include <filesystem>
#include <string>

namespace rigid_body_sim {

/// The path, relative ones from the directory, without . and .. in it.
std::string absolutePath(const std::string& path, const std::filesystem::path& directory);

/// file:// and the path, with every byte that has a meaning in a URL, or none, as %XX.
std::string fileUrl(const std::string& path);

/// The URL of a file that is for a viewer alone: what is a URL already stays as it is; a path that
/// is relative starts from the directory.
std::string viewerUrl(const std::string& reference, const std::filesystem::path& directory);

}  // namespace rigid_body_sim
