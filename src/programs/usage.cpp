#include "programs/usage.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <stdexcept>
#include <vector>

#include <getopt.h>

#include "scene/limits.hpp"

namespace rigid_body_sim {

bool asksForHelp(int argc, char** argv) {
  return std::any_of(argv + 1, argv + argc, [](const std::string& argument) {
    return argument == "--help" || argument == "-h";
  });
}

int printHelp(const char* program, const char* text) {
  std::fputs(text, stdout);
  try {
    requireWritten(stdout);
    return kDone;
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "%s: %s\n", program, error.what());
    return kBadInput;
  }
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

void requireWritten(std::FILE* out) {
  if (std::fflush(out) != 0 || std::ferror(out) != 0)
    throw std::runtime_error(std::string("standard output cannot be written: ") +
                             std::strerror(errno));
}

void requireCountable(double duration, double length, const std::string& things) {
  if (duration / length <= kMaxSteps) return;
  std::ostringstream fault;
  fault << "a duration of " << duration << " s must be at most 2^53 " << things << " of " << length
        << " s";
  throw UsageError(fault.str());
}

std::optional<std::string> readCommandLine(int argc, char** argv, const OptionActions& actions,
                                           const std::string& file_kind) {
  constexpr int kValue = 1, kHelp = 'h';
  std::vector<option> known;
  for (const auto& [name, action] : actions)
    known.push_back({name.c_str(), required_argument, nullptr, kValue});
  known.push_back({"help", no_argument, nullptr, kHelp});
  known.push_back({nullptr, 0, nullptr, 0});

  opterr = 0;  // the messages below are ours
  int index = 0;
  for (int code; (code = getopt_long(argc, argv, ":h", known.data(), &index)) != -1;) {
    if (code == kHelp) return std::nullopt;
    if (code == ':') throw UsageError(std::string(argv[optind - 1]) + " needs a value");
    if (code != kValue)
      throw UsageError("unknown option " + (optopt ? std::string("-") + static_cast<char>(optopt)
                                                   : std::string(argv[optind - 1])));
    actions.at(known[static_cast<std::size_t>(index)].name)(optarg);
  }
  if (optind + 1 != argc)
    throw UsageError("exactly one " + file_kind + " is needed, got " +
                     std::to_string(argc - optind));
  return argv[optind];
}

}  // namespace rigid_body_sim
