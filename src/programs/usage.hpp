#pragma once

#include <cstdio>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>

namespace rigid_body_sim {

/// Exit status of every program.
enum ExitCode { kDone = 0, kBadInput = 1, kWrongUsage = 2, kDiverged = 3 };

/// Wrong usage of a command line; what() is one line.
class UsageError : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
};

/// Whether --help or -h is among the arguments, for programs whose others are those of ROS.
bool asksForHelp(int argc, char** argv);

/// Writes a help text to standard output. Returns the exit status; says on standard error, after
/// the name of the program, why it cannot be written.
int printHelp(const char* program, const char* text);

/// The value of an option, named without its dashes. Throws UsageError unless it is finite and > 0.
double positiveNumber(const std::string& option, const char* text);

/// Throws std::runtime_error where what was written to an output does not get there.
void requireWritten(std::FILE* out);

/// Throws UsageError for a duration of more than kMaxSteps of the given length [s]. things: what
/// each of them is, such as "steps".
void requireCountable(double duration, double length, const std::string& things);

/// What takes the value of each option, named without its dashes.
using OptionActions = std::map<std::string, std::function<void(const char* value)>>;

/// Reads a command line of the given options and one file, which it returns; nothing where --help
/// is asked for. file_kind: for the message, such as "scene file". Throws UsageError.
std::optional<std::string> readCommandLine(int argc, char** argv, const OptionActions& actions,
                                           const std::string& file_kind);

}  // namespace rigid_body_sim
