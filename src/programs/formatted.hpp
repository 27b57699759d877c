#pragma once

#include <string>

namespace rigid_body_sim {

/// printf into a string of whatever length it takes.
__attribute__((format(printf, 1, 2))) std::string formatted(const char* format, ...);

}  // namespace rigid_body_sim
