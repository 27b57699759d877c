#pragma once

#include <string>

#include <rigid_body_sim/scene/scene.hpp>

namespace rigid_body_sim {

/// loadScene for a program: packages are those that ROS finds, and what the reader put right goes
/// to standard error, a line each after the program's name.
Scene loadToolScene(const std::string& path, const std::string& program);

/// The line that tells the user of something put right: "<program>: notice: <text>".
void printNotice(const std::string& program, const std::string& text);

}  // namespace rigid_body_sim
