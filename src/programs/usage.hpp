#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

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

/// The value of an option, named without its dashes. Throws UsageError unless it is finite and > 0.
double positiveNumber(const std::string& option, const char* text);

/// The whole number that a text is, up to `most`; none for any other text.
std::optional<std::uint64_t> wholeNumberIn(std::string_view text, std::uint64_t most);

/// The value of an option, named without its dashes. Throws UsageError unless it is a whole number
/// from least to most.
std::uint64_t wholeNumber(const std::string& option, const char* text, std::uint64_t least,
                          std::uint64_t most);

/// Throws UsageError for a duration of more than kMaxSteps of the given length [s]. things: what
/// each of them is, such as "steps".
void requireCountable(double duration, double length, const std::string& things);

/// What takes the value of each option, named without its dashes.
using OptionActions = std::map<std::string, std::function<void(const char* value)>>;

/// The entry of an option whose value is kept as it is, or as a finite number > 0.
OptionActions::value_type textInto(std::optional<std::string>& kept, const std::string& option);
OptionActions::value_type numberInto(std::optional<double>& kept, const std::string& option);

/// What an option without a value sets to true, by the option's name without its dashes.
using Flags = std::map<std::string, bool*>;

/// A number of files that stands for one or more.
constexpr int kAtLeastOne = -1;

/// Reads a command line of the given options and `count` files, which it returns; nothing where
/// --help is asked for. files: for the message, such as "exactly one file is". Throws UsageError.
std::optional<std::vector<std::string>> readCommandLine(int argc, char** argv,
                                                        const OptionActions& actions,
                                                        const std::string& files, int count,
                                                        const Flags& flags);

/// The same with one file. file_kind: such as "scene file".
std::optional<std::string> readCommandLine(int argc, char** argv, const OptionActions& actions,
                                           const std::string& file_kind, const Flags& flags = {});

}  // namespace rigid_body_sim
