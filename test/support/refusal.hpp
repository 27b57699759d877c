#pragma once

#include <stdexcept>
#include <string>

namespace rigid_body_sim::test {

/// The message with which what is asked is refused; empty where it is not.
template <class Ask>
std::string refusalOf(const Ask& ask) {
  try {
    ask();
  } catch (const std::invalid_argument& refused) {
    return refused.what();
  }
  return "";
}

}  // namespace rigid_body_sim::test
