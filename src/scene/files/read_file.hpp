#pragma once

#include <cstddef>
#include <string>

namespace rigid_body_sim {

/// " (looked for in /tmp)": where a relative path starts from, which is not everywhere where its
/// user thinks, as under roslaunch; empty of an absolute one.
std::string lookedForIn(const std::string& path);

/// Why a file could not be opened, by the errno that the attempt left, for a message that begins
/// with the path.
std::string openFault(const std::string& path, int reason);

/// The bytes of a file of at most most_bytes, a whole number of MiB. Throws SceneError with the
/// path and the reason; kind, such as "scene file", is what a directory is said not to be.
std::string readFile(const std::string& path, const std::string& kind, std::size_t most_bytes);

}  // namespace rigid_body_sim
