#pragma once

#include <cstddef>
#include <string>

namespace rigid_body_sim {

/// The bytes of a file of at most most_bytes, a whole number of MiB. Throws SceneError with the
/// path and the reason; kind, such as "scene file", is what a directory is said not to be.
std::string readFile(const std::string& path, const std::string& kind, std::size_t most_bytes);

}  // namespace rigid_body_sim
