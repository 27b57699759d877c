#include "tools/sweep/run_table.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <unistd.h>

#include "scene/files/write_file.hpp"
#include "scene/message_text.hpp"
#include "tools/sweep/sweep_ledger.hpp"
#include "tools/sweep/table_lines.hpp"

namespace rigid_body_sim {

RunTable RunTable::create(LockedFile file, const std::string& header) {
  RunTable table(std::move(file));
  table.file_.cutTo(0);
  table.append(header + "\n");
  return table;
}

RunTable RunTable::reopen(LockedFile file, std::int64_t bytes) {
  RunTable table(std::move(file));
  table.file_.cutTo(bytes);
  return table;
}

RowsRead readRows(const std::string& path, const std::string& header, std::int64_t rows,
                  const Shard& shard) {
  TableLines lines(path);
  std::string line;
  if (!lines.next(line, header.size()) || line != header)
    throw std::runtime_error(path +
                             ":1: has other columns than this sweep; remove it to begin anew");
  const std::size_t longest = longestRow(header);
  RowsRead read;
  for (std::int64_t row = 0; row < rows; ++row) {
    if (!lines.next(line, longest))
      throw std::runtime_error(path + ": has fewer rows than a moment ago");
    requireRowInPlace(path, row, line, shard);
    read.digest += digestOfRow(line);
  }
  read.bytes = lines.bytes();
  return read;
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

std::optional<std::string> beginOf(const std::string& path, std::size_t most) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return std::nullopt;
  std::string text;
  std::array<char, 1 << 12> block{};
  while (text.size() < most && in) {
    in.read(block.data(), static_cast<std::streamsize>(std::min(block.size(), most - text.size())));
    text.append(block.data(), static_cast<std::size_t>(in.gcount()));
  }
  return text;
}

void writeText(const std::string& path, const std::string& text) {
  const std::error_code fault = writeFile(path, text);
  if (!fault) return;
  errno = fault.value();
  failToWrite(path);
}

void overwriteText(const std::string& path, const std::string& text) {
  const int descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) return;
  const auto size = static_cast<off_t>(text.size());
  const bool is_whole =
      pwrite(descriptor, text.data(), text.size(), 0) == size && ftruncate(descriptor, size) == 0;
  static_cast<void>(is_whole);  // else it is read as none
  close(descriptor);
}

}  // namespace rigid_body_sim
