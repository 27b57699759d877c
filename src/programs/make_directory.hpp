#pragma once

#include <string>

namespace rigid_body_sim {

/// Makes a directory, and those that it lies in, where they are not there. Throws
/// std::runtime_error.
void makeDirectory(const std::string& path);

}  // namespace rigid_body_sim
