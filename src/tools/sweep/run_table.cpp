#include "tools/sweep/run_table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

/// The place after so many rows and the header, from the start of a file.
std::int64_t endOfRows(const std::string& path, std::int64_t rows, const Shard& shard) {
  std::ifstream in(path, std::ios::binary);
  std::string line;
  for (std::int64_t i = 0; i <= rows; ++i) {
    if (!std::getline(in, line) || in.eof())
      throw std::runtime_error(path + ": has fewer rows than a moment ago");
    if (i > 0) requireRowInPlace(path, i - 1, line, shard);
  }
  return static_cast<std::int64_t>(in.tellg());
}

}  // namespace

RunTable RunTable::create(LockedFile file, const std::string& header) {
  RunTable table(std::move(file));
  table.file_.cutTo(0);
  table.append(header + "\n");
  return table;
}

RunTable RunTable::reopen(LockedFile file, const std::string& header, std::int64_t rows,
                          const Shard& shard) {
  std::string line;
  std::getline(std::ifstream(file.path()), line);
  if (line != header)
    throw std::runtime_error(file.path() + ": is another table; remove it to begin anew");
  RunTable table(std::move(file));
  table.file_.cutTo(endOfRows(table.file_.path(), rows, shard));
  return table;
}

void requireRowInPlace(const std::string& path, std::int64_t row, const std::string& line,
                       const Shard& shard) {
  const std::int64_t run = shard.run(row);
  std::int64_t found = -1;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), found);
  if (error == std::errc() && found == run && end < line.data() + line.size() && *end == ',')
    return;
  throw std::runtime_error(path + ":" + std::to_string(row + 2) + ": must be the row of run " +
                           std::to_string(run) + ", got '" + printable(line.substr(0, 20)) +
                           "'; somebody has changed the table: remove it, and make its runs anew");
}

std::int64_t wholeRows(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::int64_t lines = 0;
  std::array<char, 1 << 16> buffer{};
  while (in.read(buffer.data(), buffer.size()) || in.gcount() > 0)
    lines += std::count(buffer.data(), buffer.data() + in.gcount(), '\n');
  return std::max<std::int64_t>(0, lines - 1);
}

bool isTableOfASweep(const std::string& path, const std::string& stem) {
  std::error_code is_gone;
  // a device has no rows to lose
  if (!std::filesystem::is_regular_file(path, is_gone)) return true;
  std::ifstream in(path, std::ios::binary);
  std::string line;
  if (!std::getline(in, line)) return true;
  const std::string head = "run,", tail = ",attitude_error,position_error,status";
  // the header may be cut where a disk was full
  const bool is_whole = !in.eof();
  return line.compare(0, head.size(), head) == 0 &&
         (stem != "runs" || !is_whole ||
          (line.size() > tail.size() &&
           line.compare(line.size() - tail.size(), tail.size(), tail) == 0));
}

void requireTableOfASweep(const std::string& path, const std::string& stem) {
  if (!isTableOfASweep(path, stem))
    throw std::runtime_error(
        path + ": is no table of a sweep, and would be replaced; remove it, or name another --out");
}

std::optional<std::string> textOf(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

void writeText(const std::string& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  out << text;
  out.close();
  if (!out) failToWrite(path);
}

}  // namespace rigid_body_sim
