#pragma once

#include <set>
#include <string>

namespace rigid_body_sim {

/// ros::init for a program that sets its own signal handlers or none. False, after one line on
/// standard error, where roscpp does not take the arguments or the address of the master.
bool initRos(int& argc, char** argv, const std::string& name, unsigned init_options = 0);

/// Names of the private parameters that arguments _NAME:=VALUE set. To be called before initRos,
/// which takes them out.
std::set<std::string> givenParameters(int argc, char** argv);

/// What is wrong with arguments NAME:=VALUE that would rename topics though they name parameters:
/// the underscore is missing. Empty: nothing.
std::string missingUnderscore(int argc, char** argv);

}  // namespace rigid_body_sim
