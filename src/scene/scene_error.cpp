#include <rigid_body_sim/scene/scene_error.hpp>

#include "scene/message_text.hpp"

namespace rigid_body_sim {

SceneError::SceneError(const std::string& message) : std::runtime_error(oneLine(message)) {}

SceneError::SceneError(const std::string& source, int line, const std::string& message)
    : SceneError(source + (line > 0 ? ":" + std::to_string(line) : "") + ": " + message) {}

}  // namespace rigid_body_sim
