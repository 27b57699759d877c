#pragma once

#include <stdexcept>
#include <string>

namespace rigid_body_sim {

/// A scene that cannot be simulated as it is written. what() is one line: file, line, place, key,
/// rule and the value found:
///   scenes/top.yaml:12: body 'top': mass must be > 0 kg, got -1
class SceneError : public std::runtime_error {
 public:
  explicit SceneError(const std::string& message);

  /// line 0: none to name.
  SceneError(const std::string& source, int line, const std::string& message);
};

}  // namespace rigid_body_sim
