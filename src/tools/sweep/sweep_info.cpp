#include "tools/sweep/sweep_info.hpp"

#include <algorithm>
#include <sstream>

#include "math/counter_draws.hpp"
#include "scene/limits.hpp"
#include "scene/message_text.hpp"
#include "scene/study/study.hpp"

namespace rigid_body_sim {
namespace {

/// The version is another where the lines are others.
constexpr const char* kFirstLine = "rigid_body_sim sweep 3";

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

std::string textOfLedger(const SweepLedger& ledger) {
  std::ostringstream text;
  text << "rows " << ledger.rows << "\nrows_digest " << ledger.digest << "\nfan_digest "
       << ledger.fan_digest << "\nno_result " << textOfNoted(ledger.refused) << "doubtful "
       << textOfNoted(ledger.doubtful) << "doubtful_at_least " << ledger.doubtful.is_at_least
       << "\ndoubtful_runs ";
  for (const std::int64_t run : ledger.doubtful_runs) text << run << ' ';
  text << "\nother_rows " << ledger.is_other << "\n";
  return text.str();
}

bool readLedger(std::istream& lines, SweepLedger& ledger) {
  return read(lines, "rows", ledger.rows) && read(lines, "rows_digest", ledger.digest) &&
         read(lines, "fan_digest", ledger.fan_digest) &&
         readNoted(lines, "no_result", ledger.refused) &&
         readNoted(lines, "doubtful", ledger.doubtful) &&
         read(lines, "doubtful_at_least", ledger.doubtful.is_at_least) &&
         readList(lines, "doubtful_runs", ledger.doubtful_runs) &&
         read(lines, "other_rows", ledger.is_other);
}

std::string textOfLost(const LostRows& lost) {
  std::ostringstream text;
  text << "lost_rows " << lost.rows << "\nlost_digest " << lost.digest << "\nlost_doubtful "
       << lost.doubtful << "\nlost_doubtful_at_least " << lost.is_at_least << "\n";
  return text.str();
}

bool readLost(std::istream& lines, LostRows& lost) {
  return read(lines, "lost_rows", lost.rows) && read(lines, "lost_digest", lost.digest) &&
         read(lines, "lost_doubtful", lost.doubtful) &&
         read(lines, "lost_doubtful_at_least", lost.is_at_least);
}

/// Whether they are numbers of runs, each once, in their order.
bool areRuns(const std::vector<std::int64_t>& named, std::int64_t runs) {
  return named.size() <= SweepLedger::kMaxNamed && std::is_sorted(named.begin(), named.end()) &&
         std::adjacent_find(named.begin(), named.end()) == named.end() &&
         (named.empty() || (named.front() >= 0 && named.back() < runs));
}

/// Whether sums of them stay numbers.
bool isPossible(const TableInfo& info) {
  const auto& [sweep, ledger, lost] = info;
  const auto isWithin = [](std::int64_t n, std::int64_t most) { return n >= 0 && n <= most; };
  return isWithin(sweep.runs, kMaxSweepRuns) && sweep.varied <= kMaxVariedPaths &&
         sweep.records <= kMaxRecords && isWithin(ledger.rows, sweep.runs) &&
         isWithin(ledger.refused.count, ledger.rows) &&
         isWithin(ledger.doubtful.count, ledger.rows) && isWithin(lost.rows, sweep.runs) &&
         isWithin(lost.doubtful, lost.rows) && (lost.rows == 0 || lost.rows >= ledger.rows) &&
         areRuns(ledger.doubtful_runs, sweep.runs);
}

}  // namespace

std::string toText(const TableInfo& info) {
  const SweepInfo& sweep = info.sweep;
  std::ostringstream lines;
  lines << kFirstLine << "\ntitle " << oneLine(sweep.title) << "\ndigest " << sweep.digest
        << "\nruns " << sweep.runs << "\nvaried " << sweep.varied << "\nrecords " << sweep.records
        << "\nfan " << oneLine(sweep.fan) << "\n"
        << textOfLedger(info.ledger) << textOfLost(info.lost);
  const std::string text = lines.str();
  return text + "seal " + std::to_string(digestOf({text})) + "\n";
}

std::optional<TableInfo> tableInfoIn(const std::string& text) {
  std::istringstream lines(text);
  std::string first;
  std::getline(lines, first);
  TableInfo info;
  SweepInfo& sweep = info.sweep;
  const auto title = valueOf(lines, "title");
  const bool numbers = read(lines, "digest", sweep.digest) && read(lines, "runs", sweep.runs) &&
                       read(lines, "varied", sweep.varied) && read(lines, "records", sweep.records);
  const auto fan = numbers ? valueOf(lines, "fan") : std::nullopt;
  if (!title || !fan) return std::nullopt;
  sweep.title = *title;
  sweep.fan = *fan;
  const bool is_read = readLedger(lines, info.ledger) && readLost(lines, info.lost);
  // with its first line, its seal, and whatever else may have been changed
  return is_read && isPossible(info) && toText(info) == text ? std::optional(info) : std::nullopt;
}

std::string faultOfInfo(const std::optional<std::string>& text) {
  if (!text) return "is not there";
  if (text->empty()) return "is empty";
  const std::string first = text->substr(0, text->find('\n'));
  const std::string mark = kInfoMark;
  if (first.compare(0, mark.size(), mark) != 0) return "is not of a sweep";
  if (first != kFirstLine && text->size() > first.size())
    return "is of another version of this program, '" + printable(first) + "', not '" + kFirstLine +
           "'";
  return "is not as it was written: somebody has changed it, or it was cut";
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
