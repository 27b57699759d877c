#pragma once

#include <cstdlib>
#include <string>

namespace rigid_body_sim {

/// Aborts, as libFuzzer takes for a finding, unless a message is one line of at most so many bytes.
inline void requireOneLine(const std::string& message, std::size_t most = 10000) {
  if (message.find_first_of("\n\r") != std::string::npos || message.size() > most) std::abort();
}

}  // namespace rigid_body_sim
