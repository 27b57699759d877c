#include "scene/files/viewer_url.hpp"

#include <system_error>

namespace rigid_body_sim {

std::string absolutePath(const std::string& path, const std::filesystem::path& directory) {
  std::error_code no_working_directory;  // then the path stays relative, and is not found
  const auto absolute = std::filesystem::absolute(directory / path, no_working_directory);
  return (no_working_directory ? directory / path : absolute).lexically_normal().string();
}

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

std::string viewerUrl(const std::string& reference, const std::filesystem::path& directory) {
  if (reference.find("://") != std::string::npos) return reference;
  return fileUrl(absolutePath(reference, directory));
}

}  // namespace rigid_body_sim
