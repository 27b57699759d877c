#pragma once

#include <string>

namespace rigid_body_sim {

/// The bytes of a text file of at most 16 MiB. Throws SceneError with the path and the reason;
/// kind, such as "scene file", is what a directory is said not to be.
std::string readFile(const std::string& path, const std::string& kind);

}  // namespace rigid_body_sim
