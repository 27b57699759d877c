#include "tools/sweep/sweep_info.hpp"

#include <sstream>

#include "math/counter_draws.hpp"

namespace rigid_body_sim {
namespace {

constexpr const char* kFirstLine = "rigid_body_sim sweep 1";

/// The rest of a line that begins with a word.
std::optional<std::string> valueOf(std::istream& lines, const std::string& word) {
  std::string line;
  if (!std::getline(lines, line) || line.rfind(word + " ", 0) != 0) return std::nullopt;
  return line.substr(word.size() + 1);
}

template <class Number>
bool read(std::istream& lines, const std::string& word, Number& number) {
  const std::optional<std::string> text = valueOf(lines, word);
  std::istringstream in(text.value_or(""));
  return text && in >> number && in.peek() == std::istringstream::traits_type::eof();
}

}  // namespace

std::string toText(const SweepInfo& info) {
  std::ostringstream text;
  text << kFirstLine << "\ntitle " << info.title << "\ndigest " << info.digest << "\nruns "
       << info.runs << "\nvaried " << info.varied << "\nrecords " << info.records << "\nfan "
       << info.fan << "\n";
  return text.str();
}

std::optional<SweepInfo> sweepInfoIn(const std::string& text) {
  std::istringstream lines(text);
  std::string first;
  std::getline(lines, first);
  SweepInfo info;
  const auto title = valueOf(lines, "title");
  const bool numbers = read(lines, "digest", info.digest) && read(lines, "runs", info.runs) &&
                       read(lines, "varied", info.varied) && read(lines, "records", info.records);
  const auto fan = numbers ? valueOf(lines, "fan") : std::nullopt;
  if (first != kFirstLine || !title || !fan) return std::nullopt;
  info.title = *title;
  info.fan = *fan;
  return info;
}

bool isSameSweep(const SweepInfo& a, const SweepInfo& b) {
  return a.digest == b.digest && a.runs == b.runs && a.varied == b.varied &&
         a.records == b.records && a.fan == b.fan;
}

std::uint64_t digestOf(const std::vector<std::string>& texts) {
  std::uint64_t digest = 0;
  for (const std::string& text : texts) digest = drawKey(digest, text);
  return digest;
}

}  // namespace rigid_body_sim
