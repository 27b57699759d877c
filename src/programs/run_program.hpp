#pragma once

#include <functional>
#include <string>

namespace rigid_body_sim {

/// The main function of a program without a ROS master: reserves the standard streams, runs the
/// body, and reports what it throws in one line on standard error: "<name>: <what>". Returns the
/// ExitCode.
int runProgram(const std::string& name, const std::function<void()>& body);

/// Prints a help text. Returns the ExitCode: no help that cannot be read is a success.
int printHelp(const std::string& name, const std::string& text);

}  // namespace rigid_body_sim
