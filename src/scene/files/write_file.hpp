#pragma once

#include <string>
#include <system_error>

namespace rigid_body_sim {

/// Writes a file, which takes the place of the one before once it is whole; where links lead to it,
/// they stay. What is no regular file, such as a device or a pipe, is written through. Returns what
/// went wrong: a file that was there is then as it was.
std::error_code writeFile(const std::string& path, const std::string& text);

/// What would go wrong, as far as that can be known without writing the file.
std::error_code writeFault(const std::string& path);

}  // namespace rigid_body_sim
