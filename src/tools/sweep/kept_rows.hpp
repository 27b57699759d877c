#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tools/sweep/shard.hpp"
#include "tools/sweep/sweep_info.hpp"
#include "tools/sweep/table_fields.hpp"

namespace rigid_body_sim {

/// What an interrupted sweep has left that can be gone on with.
struct KeptRows {
  SweepLedger ledger{};  ///< of the rows
  LostRows lost{};
  std::int64_t bytes = 0;      ///< of the table up to their end
  std::int64_t fan_rows = 0;   ///< that the fan should have by now
  std::int64_t fan_bytes = 0;  ///< up to their end; 0: they must be made again
  std::vector<std::string> notices{};
};

/// The tables that a sweep writes, as their first lines say.
struct TableHeaders {
  std::string runs, fan;
  RowForm form;  ///< of the rows of the first
};

/// Reads them. Throws std::runtime_error where they are of another sweep, or not as they were
/// written. Without a row there is nothing to go on with.
KeptRows keptRows(const ShardFiles& files, const SweepInfo& info, const TableHeaders& headers);

/// Where rows were lost, and made again were not the same.
std::string noticeOfOtherRows(const ShardFiles& files);

/// Throws std::runtime_error where a sweep that begins anew would take rows away that it should go
/// on with; returns a notice where it takes others away.
std::string refuseToReplace(const ShardFiles& files, const SweepInfo& info);

/// Throws std::runtime_error for rows which are not those of a ledger: for the first whose form is
/// not that of a row where there is one. There are at least as many as in the ledger.
void requireLedger(const ShardFiles& files, const SweepLedger& ledger, std::uint64_t digest,
                   const RowForm& form);

/// Throws std::runtime_error for what is in a whole table behind its rows.
[[noreturn]] void refuseMoreThan(const std::string& path, std::int64_t rows);

/// The same as requireLedger for the rows of a fan, by the path of that.
void requireFan(const std::string& path, const SweepLedger& ledger, std::uint64_t digest);

}  // namespace rigid_body_sim
