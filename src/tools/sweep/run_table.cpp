#include "tools/sweep/run_table.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

[[noreturn]] void failToWrite(const std::string& path) {
  throw std::runtime_error(path + ": cannot be written: " + std::strerror(errno));
}

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

RunTable::RunTable(std::string path, int flags)
    : path_(std::move(path)),
      descriptor_(open(path_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC | flags, 0666)) {
  if (descriptor_ < 0) failToWrite(path_);
  // a file system without locks is taken as it is
  if (flock(descriptor_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(descriptor_);
  throw std::runtime_error(path_ +
                           ": another sweep is writing it; wait for it, or name another --out");
}

void RunTable::cutTo(std::int64_t bytes) {
  // a device cannot be cut, and has no rows to keep
  if (ftruncate(descriptor_, bytes) != 0 && errno != EINVAL) failToWrite(path_);
}

RunTable::RunTable(RunTable&& other) noexcept
    : path_(std::move(other.path_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

RunTable::~RunTable() {
  if (descriptor_ >= 0) close(descriptor_);
}

RunTable RunTable::create(const std::string& path, const std::string& header) {
  RunTable table(path, O_CREAT);
  table.cutTo(0);
  table.append(header + "\n");
  return table;
}

RunTable RunTable::reopen(const std::string& path, const std::string& header, std::int64_t rows,
                          const Shard& shard) {
  std::string line;
  std::getline(std::ifstream(path), line);
  if (line != header)
    throw std::runtime_error(path + ": is another table; remove it, or leave --resume out");
  RunTable table(path, 0);
  table.cutTo(endOfRows(path, rows, shard));
  return table;
}

void RunTable::append(const std::string& rows) {
  const off_t before = lseek(descriptor_, 0, SEEK_END);
  for (std::size_t done = 0; done < rows.size();) {
    const ssize_t n = write(descriptor_, rows.data() + done, rows.size() - done);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      const int why = errno;
      // a device cannot be cut, and has no rows to keep whole
      const bool is_cut = before >= 0 && ftruncate(descriptor_, before) == 0;
      static_cast<void>(is_cut);
      errno = why;
      failToWrite(path_);
    }
    done += static_cast<std::size_t>(n);
  }
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
