#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

#include "fuzz/one_line.hpp"
#include "support/temporary_directory.hpp"
#include "tools/sweep/kept_rows.hpp"
#include "tools/sweep/merge_shards.hpp"
#include "tools/sweep/run_table.hpp"
#include "tools/sweep/sweep_summary.hpp"

namespace rigid_body_sim {
namespace {

void require(bool holds) {
  if (!holds) std::abort();
}

/// runs.info with a seal that fits, so that not every change ends there.
std::string sealed(const std::string& lines) {
  return lines + "seal " + std::to_string(digestOf({lines})) + "\n";
}

/// What a sweep would say of its rows, had it written these, where it says that it knows them: a
/// rows_digest of 0.
TableInfo knowing(TableInfo info, const std::string& table) {
  if (info.ledger.digest != 0) return info;
  std::istringstream lines(table);
  std::string line;
  std::getline(lines, line);
  for (std::int64_t row = 0; row < info.ledger.rows && std::getline(lines, line); ++row)
    info.ledger.digest += digestOfRow(line);
  return info;
}

void resume(const ShardFiles& files, const TableInfo& info, const std::string& table) {
  const std::string header = table.substr(0, table.find('\n'));
  const auto columns = static_cast<std::size_t>(1 + std::count(header.begin(), header.end(), ','));
  const KeptRows kept =
      keptRows(files, info.sweep, {header, "", {columns, info.sweep.varied, info.sweep.records}});
  for (const std::string& notice : kept.notices) requireOneLine(notice);
  require(kept.bytes >= 0 && kept.bytes <= static_cast<std::int64_t>(table.size()));
  require(kept.ledger.rows ==
          std::count(table.begin(), table.begin() + kept.bytes, '\n') - (kept.bytes > 0 ? 1 : 0));
  require(kept.lost.rows == 0 || kept.lost.rows >= kept.ledger.rows);
  // it can be gone on with
  require(tableInfoIn(toText({info.sweep, kept.ledger, kept.lost})).has_value());
}

void replace(const ShardFiles& files, const TableInfo& info) {
  requireOneLine(refuseToReplace(files, info.sweep));
}

void merge(const std::string& directory, const std::string& out, const std::string& table) {
  const auto merged = mergeShards({directory}, out, std::atomic<bool>(false));
  const std::string path = out + "/runs.csv";
  require(merged && beginOf(path, table.size() + 1) == table);
  summaryCsv(summarise(path, merged->sweep));
}

}  // namespace
}  // namespace rigid_body_sim

/// Any text, up to an empty line, is read as what stands beside a table, and the rest as the table
/// that --resume and merge go on with, or refused in one line.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace rigid_body_sim;
  static const TemporaryDirectory files;
  const std::string text(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(text.find("\n\n"), size);
  const std::string lines = text.substr(0, end) + "\n";
  const std::string table = end < size ? text.substr(end + 2) : "";
  requireOneLine(faultOfInfo(text));
  if (const auto unsealed = tableInfoIn(text)) require(toText(*unsealed) == text);
  const std::optional<TableInfo> read = tableInfoIn(sealed(lines));
  files.written("out/runs.csv", table);
  files.written("out/runs.info", read ? toText(knowing(*read, table)) : lines);
  const ShardFiles out{Shard{}, files.path("out")};
  const auto refuses = [](auto read_on) {
    try {
      read_on();
    } catch (const std::runtime_error& refused) {
      requireOneLine(refused.what());
    }
  };
  refuses([&] { resume(out, read.value_or(TableInfo{}), table); });
  refuses([&] { replace(out, read.value_or(TableInfo{})); });
  refuses([&] { merge(files.path("out"), files.path("merged"), table); });
  return 0;
}
