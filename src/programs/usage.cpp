#include "programs/usage.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <set>
#include <sstream>
#include <vector>

#include <getopt.h>

#include "scene/limits.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

constexpr int kHelp = 'h';
constexpr int kFirstLong = 256;  // code of the first long option, beyond all characters

/// Why an option is refused: getopt_long has left its letter in `code`, of a long one that takes no
/// value its code, and 0 of a long one that is unknown or short for several.
std::string refusedOption(const std::string& argument, const std::vector<option>& known, int code) {
  if (code > 0 && code < kFirstLong)
    return std::string("unknown option -") + static_cast<char>(code);
  const std::string given = argument.substr(2, argument.find('=') - 2);
  std::string longer;
  for (const option* of = known.data(); of->name; ++of) {
    if (of->val == code) return "--" + std::string(of->name) + " takes no value";
    if (std::string(of->name).rfind(given, 0) == 0)
      longer += (longer.empty() ? "--" : ", --") + std::string(of->name);
  }
  if (longer.empty()) return "unknown option " + argument;
  return "option --" + given + " is short for several, " + longer + ": write one in full";
}

void takeValue(const std::string& option, const char* text,
               const OptionActions::mapped_type& action) {
  if (*text == '\0') throw UsageError("--" + option + ": must not be empty");
  action(text);
}

}  // namespace

bool asksForHelp(int argc, char** argv) {
  return std::any_of(argv + 1, argv + argc, [](const std::string& argument) {
    return argument == "--help" || argument == "-h";
  });
}

double positiveNumber(const std::string& option, const char* text) {
  char* end = nullptr;
  const double x = std::strtod(text, &end);
  // strtod takes more than a scene: blanks before, hexadecimals
  const bool decimal = std::string(text).find_first_not_of("+-.0123456789eE") == std::string::npos;
  if (end == text || *end != '\0' || !decimal || !std::isfinite(x) || !(x > 0))
    throw UsageError("--" + option + ": must be a finite number > 0, got '" + text + "'");
  return x;
}

std::optional<std::uint64_t> wholeNumberIn(std::string_view text, std::uint64_t most) {
  const char* const end = text.data() + text.size();
  std::uint64_t number = 0;
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (text.empty() || rest != end || error != std::errc() || number > most) return std::nullopt;
  return number;
}

std::uint64_t wholeNumber(const std::string& option, const char* text, std::uint64_t least,
                          std::uint64_t most) {
  const std::optional<std::uint64_t> number = wholeNumberIn(text, most);
  if (!number || *number < least)
    throw UsageError("--" + option + ": must be a whole number from " + std::to_string(least) +
                     " to " + std::to_string(most) + ", got '" + printable(text) + "'");
  return *number;
}

OptionActions::value_type textInto(std::optional<std::string>& kept, const std::string& option) {
  return {option, [&kept](const char* text) { kept = text; }};
}

OptionActions::value_type numberInto(std::optional<double>& kept, const std::string& option) {
  return {option, [&kept, option](const char* text) { kept = positiveNumber(option, text); }};
}

void requireCountable(double duration, double length, const std::string& things) {
  if (duration / length <= kMaxSteps) return;
  std::ostringstream fault;
  fault << "a duration of " << duration << " s must be at most 2^53 " << things << " of " << length
        << " s";
  throw UsageError(fault.str());
}

std::optional<std::string> readCommandLine(int argc, char** argv, const OptionActions& actions,
                                           const std::string& file_kind, const Flags& flags) {
  const auto files =
      readCommandLine(argc, argv, actions, "exactly one " + file_kind + " is", 1, flags);
  return files ? std::optional(files->front()) : std::nullopt;
}

std::optional<std::vector<std::string>> readCommandLine(int argc, char** argv,
                                                        const OptionActions& actions,
                                                        const std::string& files, int count,
                                                        const Flags& flags) {
  std::vector<option> known;
  const auto add = [&](const char* name, int argument) {
    known.push_back({name, argument, nullptr, kFirstLong + static_cast<int>(known.size())});
  };
  for (const auto& [name, action] : actions) add(name.c_str(), required_argument);
  for (const auto& [name, flag] : flags) add(name.c_str(), no_argument);
  add("help", no_argument);
  known.push_back({nullptr, 0, nullptr, 0});

  std::set<std::string> given;
  opterr = 0;  // the messages below are ours
  for (int code; (code = getopt_long(argc, argv, ":h", known.data(), nullptr)) != -1;) {
    if (code == ':') throw UsageError(std::string(argv[optind - 1]) + " needs a value");
    if (code == '?') throw UsageError(refusedOption(argv[optind - 1], known, optopt));
    const std::string name =
        code == kHelp ? "help" : known[static_cast<std::size_t>(code - kFirstLong)].name;
    if (name == "help") return std::nullopt;
    if (!given.insert(name).second) throw UsageError("--" + name + " is given twice");
    const auto flag = flags.find(name);
    if (flag != flags.end())
      *flag->second = true;
    else
      takeValue(name, optarg, actions.at(name));
  }
  if (count == kAtLeastOne ? optind == argc : optind + count != argc)
    throw UsageError(files + " needed, got " + std::to_string(argc - optind));
  if (std::any_of(argv + optind, argv + argc, [](const char* name) { return *name == '\0'; }))
    throw UsageError("an argument is empty: it must be a path");
  return std::vector<std::string>(argv + optind, argv + argc);
}

}  // namespace rigid_body_sim
