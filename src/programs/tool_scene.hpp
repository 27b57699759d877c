#pragma once

#include <string>

#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// loadScene for a program: packages are those that ROS finds.
Scene loadToolScene(const std::string& path);

/// The line that tells the user of something put right: "<program>: notice: <text>".
std::string noticeLine(const std::string& program, const std::string& text);

}  // namespace rigid_body_sim
