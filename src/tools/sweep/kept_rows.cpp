#include "tools/sweep/kept_rows.hpp"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <stdexcept>

#include "tools/sweep/run_table.hpp"
#include "tools/sweep/table_lines.hpp"

namespace rigid_body_sim {
namespace {

/// What tells of which sweep the rows of a table are. Throws where nothing does.
TableInfo infoBeside(const ShardFiles& files) {
  const std::string path = files.path("runs", ".info");
  const std::optional<std::string> text = beginOf(path, kMaxInfoBytes);
  if (const auto info = tableInfoIn(text.value_or(""))) return *info;
  const std::string table = files.shard.fileName("runs", ".csv");
  throw std::runtime_error(path + ": " + faultOfInfo(text) +
                           "; only by it is known of which sweep the rows of " + table +
                           " are: put it back, or remove " + table + " to begin anew");
}

void requireSameSweep(const ShardFiles& files, const SweepInfo& there, const SweepInfo& info) {
  if (isSameSweep(there, info)) return;
  const std::string table = files.path("runs", ".csv");
  SweepInfo as_many = there;
  as_many.runs = info.runs;
  if (isSameSweep(as_many, info))
    throw std::runtime_error(table + ": is of " + std::to_string(there.runs) +
                             " runs, with the grids, and not of " + std::to_string(info.runs) +
                             "; --runs was another");
  throw std::runtime_error(
      table +
      ": is of another sweep: the scene, the study, the seed, or a file that the scene names is "
      "another; name another --out, or remove it to begin anew");
}

/// What can be known of the first rows of a table that has lost its last ones, by their form.
SweepLedger ledgerByForm(const ShardFiles& files, const SweepLedger& whole, std::int64_t rows,
                         const RowForm& form) {
  const std::string path = files.path("runs", ".csv");
  TableLines lines(path);
  std::string line;
  lines.next(line, std::string::npos);
  const std::size_t longest = longestRow(line);
  SweepLedger ledger;
  std::vector<std::string_view> fields;
  for (; ledger.rows < rows && lines.next(line, longest); ++ledger.rows) {
    splitFields(line, fields);
    ledger.digest += digestOfRow(line);
    if (!requireForm(fields, form, path + ":" + std::to_string(ledger.rows + 2)))
      ledger.refused.add(files.shard.run(ledger.rows), std::string(fields.back()));
  }
  ledger.addDoubtsBefore(files.shard.run(rows), whole);
  ledger.is_other = whole.is_other;
  return ledger;
}

/// Those of the first loss are those that are known to have been written.
LostRows lostOf(const TableInfo& info) {
  const SweepLedger& written = info.ledger;
  if (info.lost.rows > 0) return info.lost;
  return {written.rows, written.digest, written.doubtful.count, written.doubtful.is_at_least};
}

/// A table without a row.
KeptRows nothingKept(const ShardFiles& files, const SweepInfo& info) {
  KeptRows kept;
  const auto beside = tableInfoIn(beginOf(files.path("runs", ".info"), kMaxInfoBytes).value_or(""));
  if (!beside || !isSameSweep(beside->sweep, info) || beside->ledger.rows == 0) return kept;
  kept.lost = lostOf(*beside);
  kept.notices.push_back(files.path("runs", ".csv") + ": has lost all its rows, of " +
                         std::to_string(beside->ledger.rows) + ", which are made again");
  return kept;
}

/// Of what is behind the rows that are known: no sweep writes more rows than it has runs; else it
/// is what was written until a process was killed, and is made again.
void lookBehind(const std::string& path, const RowsRead& read, std::int64_t rows, std::int64_t all,
                KeptRows& kept) {
  std::error_code is_gone;
  const auto bytes = std::filesystem::file_size(path, is_gone);
  if (is_gone || static_cast<std::int64_t>(bytes) <= read.bytes) return;
  if (rows == all) refuseMoreThan(path, all);
  kept.notices.push_back(path + ": its first " + std::to_string(rows) +
                         " rows are kept; what is behind them is not in runs.info, and is made "
                         "again");
}

void keepFan(const ShardFiles& files, const SweepInfo& info, const SweepLedger& written,
             std::int64_t written_rows, const std::string& header, KeptRows& kept) {
  const std::string path = files.path("fan", ".csv");
  if (wholeRows(path) < kept.fan_rows) {
    kept.notices.push_back(path + ": has lost rows, which are made again");
    return;
  }
  if (!written.knowsFan()) {
    kept.notices.push_back(path + ": its rows are not in runs.info, and are made again");
    return;
  }
  const RowsRead fan = readRows(path, header, kept.fan_rows, files.shard);
  // of fewer rows than were written nothing is known
  if (kept.fan_rows != written_rows) return;
  requireFan(path, written, fan.digest);
  lookBehind(path, fan, kept.fan_rows, files.shard.runsOf(info.fanRuns()), kept);
  kept.ledger.fan_digest = fan.digest;
  kept.fan_bytes = fan.bytes;
}

}  // namespace

void requireFan(const std::string& path, const SweepLedger& ledger, std::uint64_t digest) {
  if (digest == ledger.fan_digest) return;
  throw std::runtime_error(path +
                           ": its rows are not those that were written; somebody has changed the "
                           "table: remove it, and --resume makes it again");
}

void refuseMoreThan(const std::string& path, std::int64_t rows) {
  throw std::runtime_error(path + ": has more than the " + std::to_string(rows) +
                           " rows of its runs; somebody has changed the table: remove what is "
                           "behind them, or make its runs anew");
}

void requireLedger(const ShardFiles& files, const SweepLedger& ledger, std::uint64_t digest,
                   const RowForm& form) {
  if (digest == ledger.digest) return;
  ledgerByForm(files, ledger, ledger.rows, form);
  throw std::runtime_error(files.path("runs", ".csv") +
                           ": its rows are not those that were written; somebody has changed the "
                           "table: remove it, and make its runs anew");
}

std::string noticeOfOtherRows(const ShardFiles& files) {
  return files.path("runs", ".csv") +
         ": with the runs that were lost its rows are not those that were written: somebody has "
         "changed it, or this machine computes other digits; to be sure, remove it and make its "
         "runs anew";
}

KeptRows keptRows(const ShardFiles& files, const SweepInfo& info, const TableHeaders& headers) {
  const std::string table = files.path("runs", ".csv");
  const std::int64_t there = wholeRows(table);
  if (there == 0) return nothingKept(files, info);
  KeptRows kept;
  const TableInfo beside = infoBeside(files);
  requireSameSweep(files, beside.sweep, info);
  const SweepLedger& written = beside.ledger;
  const std::int64_t rows = std::min(there, written.rows);
  if (rows == 0) {
    kept.notices.push_back(table + ": its rows are not in runs.info, and are made again");
    return kept;
  }
  const RowsRead read = readRows(table, headers.runs, rows, files.shard);
  kept.lost = beside.lost;
  if (rows == written.rows) {
    requireLedger(files, written, read.digest, headers.form);
    lookBehind(table, read, rows, files.shard.runsOf(info.runs), kept);
    kept.ledger = written;
    kept.ledger.fan_digest = 0;
  } else {
    kept.ledger = ledgerByForm(files, written, rows, headers.form);
    kept.lost = lostOf(beside);
    kept.notices.push_back(table + ": has lost its last rows, of " + std::to_string(written.rows) +
                           "; of the " + std::to_string(rows) +
                           " that are left only the form could be checked");
  }
  if (written.is_other) kept.notices.push_back(noticeOfOtherRows(files));
  kept.bytes = read.bytes;
  const auto fan_rows = [&](std::int64_t n) {
    return std::min(n, files.shard.runsOf(info.fanRuns()));
  };
  kept.fan_rows = fan_rows(rows);
  if (!info.fan.empty() && kept.fan_rows > 0)
    keepFan(files, info, written, fan_rows(written.rows), headers.fan, kept);
  return kept;
}

std::string refuseToReplace(const ShardFiles& files, const SweepInfo& info) {
  const std::string table = files.path("runs", ".csv");
  const std::int64_t rows = wholeRows(table);
  if (rows == 0) return "";
  // without it they may be of this sweep
  const SweepInfo beside = infoBeside(files).sweep;
  const std::int64_t all = files.shard.runsOf(beside.runs);
  if (rows >= all) return "";
  const std::string holds =
      table + ": holds " + std::to_string(rows) + " of " + std::to_string(all) + " runs of ";
  if (isSameSweep(beside, info))
    throw std::runtime_error(holds + "this sweep; --resume goes on, or remove it to begin anew");
  return holds + beside.title + ", which are replaced";
}

}  // namespace rigid_body_sim
