#include "tools/sweep/sweep_info.hpp"

#include <sstream>

#include "math/counter_draws.hpp"
#include "scene/message_text.hpp"

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

std::string textOfNoted(const NotedRuns& noted) {
  return std::to_string(noted.count) + " " + std::to_string(noted.first) + " " +
         oneLine(noted.why) + "\n";
}

bool readNoted(std::istream& lines, const std::string& word, NotedRuns& noted) {
  std::istringstream in(valueOf(lines, word).value_or(""));
  if (!(in >> noted.count >> noted.first)) return false;
  in.get();
  std::getline(in, noted.why);
  return true;
}

bool readList(std::istream& lines, const std::string& word, std::vector<std::int64_t>& list) {
  const auto text = valueOf(lines, word);
  std::istringstream in(text.value_or(""));
  for (std::int64_t run = 0; in >> run;) list.push_back(run);
  return text && in.eof();
}

}  // namespace

std::string toText(const TableInfo& info) {
  const SweepInfo& sweep = info.sweep;
  const SweepLedger& ledger = info.ledger;
  std::ostringstream text;
  text << kFirstLine << "\ntitle " << sweep.title << "\ndigest " << sweep.digest << "\nruns "
       << sweep.runs << "\nvaried " << sweep.varied << "\nrecords " << sweep.records << "\nfan "
       << sweep.fan << "\nrows " << ledger.rows << "\nrows_digest " << ledger.digest
       << "\nfan_digest " << ledger.fan_digest << "\nno_result " << textOfNoted(ledger.refused)
       << "doubtful " << textOfNoted(ledger.doubtful) << "doubtful_runs ";
  for (const std::int64_t run : ledger.doubtful_runs) text << run << ' ';
  text << "\n";
  return text.str();
}

std::optional<TableInfo> tableInfoIn(const std::string& text) {
  std::istringstream lines(text);
  std::string first;
  std::getline(lines, first);
  TableInfo info;
  SweepInfo& sweep = info.sweep;
  SweepLedger& ledger = info.ledger;
  const auto title = valueOf(lines, "title");
  const bool numbers = read(lines, "digest", sweep.digest) && read(lines, "runs", sweep.runs) &&
                       read(lines, "varied", sweep.varied) && read(lines, "records", sweep.records);
  const auto fan = numbers ? valueOf(lines, "fan") : std::nullopt;
  if (first != kFirstLine || !title || !fan) return std::nullopt;
  sweep.title = *title;
  sweep.fan = *fan;
  const bool is_whole = read(lines, "rows", ledger.rows) &&
                        read(lines, "rows_digest", ledger.digest) &&
                        read(lines, "fan_digest", ledger.fan_digest) &&
                        readNoted(lines, "no_result", ledger.refused) &&
                        readNoted(lines, "doubtful", ledger.doubtful) &&
                        readList(lines, "doubtful_runs", ledger.doubtful_runs);
  return is_whole ? std::optional(info) : std::nullopt;
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
