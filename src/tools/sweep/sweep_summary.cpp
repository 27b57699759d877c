#include "tools/sweep/sweep_summary.hpp"

#include <cmath>
#include <stdexcept>
#include <string_view>

#include "programs/formatted.hpp"
#include "scene/files/number_text.hpp"
#include "tools/sweep/table_fields.hpp"
#include "tools/sweep/table_lines.hpp"

namespace rigid_body_sim {
namespace {

void keep(ColumnSummary& column, double x) {
  if (!std::isnan(x)) column.add(x);
  if (column.kept.size() < SweepSummary::kKeptRows) column.kept.push_back(x);
}

SweepSummary columnsOf(const SweepInfo& info, const std::vector<std::string>& names) {
  SweepSummary summary;
  summary.records = info.records;
  for (std::size_t i = 1; i + 1 < names.size(); ++i) {
    ColumnSummary column;
    column.name = names[i];
    (i <= info.varied ? summary.varied : summary.results).push_back(std::move(column));
  }
  summary.pairs.assign(summary.results.size(), std::vector<PairSummary>(summary.varied.size()));
  return summary;
}

void addRow(const std::vector<std::string_view>& fields, const std::string& path,
            SweepSummary& summary, std::vector<double>& inputs) {
  ++summary.rows;
  if (!isDone(fields.back(), path + ":" + std::to_string(summary.rows + 1))) return;
  ++summary.done;
  inputs.clear();
  for (std::size_t i = 0; i < summary.varied.size(); ++i) {
    inputs.push_back(numberInField(fields[i + 1]));
    keep(summary.varied[i], inputs.back());
  }
  for (std::size_t k = 0; k < summary.results.size(); ++k) {
    const double y = numberInField(fields[summary.varied.size() + 1 + k]);
    keep(summary.results[k], y);
    for (std::size_t i = 0; i < inputs.size() && !std::isnan(y); ++i)
      if (!std::isnan(inputs[i])) summary.pairs[k][i].add(inputs[i], y);
  }
}

constexpr std::pair<const char*, double> kPercentiles[] = {
    {"p1", 0.01},  {"p5", 0.05},  {"p25", 0.25}, {"p50", 0.5},
    {"p75", 0.75}, {"p95", 0.95}, {"p99", 0.99}};

std::string rowOf(const ColumnSummary& column, const std::vector<PairSummary>* pairs,
                  std::size_t varied) {
  std::string row = column.name + "," + std::to_string(column.count);
  if (column.count == 0) return row + std::string(11 + varied, ',') + "\n";
  const auto add = [&](double x) {
    row += ',';
    // of values near the greatest number there is a sum may be none
    if (std::isfinite(x)) appendNumber(x, row);
  };
  add(column.mean);
  add(column.stddev());
  add(column.least);
  for (const auto& [name, share] : kPercentiles) add(column.percentile(share));
  add(column.greatest);
  for (std::size_t i = 0; i < varied; ++i) {
    const std::optional<double> r = pairs ? (*pairs)[i].correlation() : std::nullopt;
    if (r)
      add(*r);
    else
      row += ',';
  }
  return row + "\n";
}

std::string tableRow(const SweepSummary& summary, const ColumnSummary& column,
                     std::optional<std::size_t> result) {
  std::string row = formatted("  %-34s", column.name.c_str());
  const auto add = [&](double x, int width, int digits) {
    row += std::isfinite(x) ? formatted(" %*.*g", width, digits, x) : formatted(" %*s", width, "-");
  };
  add(column.mean, 11, 5);
  add(column.stddev(), 10, 3);
  for (const double share : {0.05, 0.5, 0.95}) add(column.percentile(share), 11, 5);
  const auto most = result ? summary.mostCorrelated(*result) : std::nullopt;
  if (most)
    row += formatted("  %+.2f with %s", *summary.pairs[*result][*most].correlation(),
                     summary.varied[*most].name.c_str());
  return row + "\n";
}

}  // namespace

SweepSummary summarise(const std::string& path, const SweepInfo& info) {
  TableLines lines(path);
  std::string line;
  std::vector<std::string_view> fields;
  if (!lines.next(line, std::string::npos)) throw std::runtime_error(path + ": cannot be read");
  splitFields(line, fields);
  std::vector<std::string> names;
  for (const std::string_view name : fields) names.emplace_back(name);
  if (names.size() < info.varied + info.records + 4)
    throw std::runtime_error(path + ": is no table of a sweep");
  SweepSummary summary = columnsOf(info, names);
  const std::size_t longest = longestRow(line);
  std::vector<double> inputs;
  while (lines.next(line, longest)) {
    summary.digest += digestOfRow(line);
    splitFields(line, fields);
    if (fields.size() != names.size())
      throw std::runtime_error(path + ":" + std::to_string(summary.rows + 2) + ": must have " +
                               std::to_string(names.size()) + " fields, got " +
                               std::to_string(fields.size()));
    addRow(fields, path, summary, inputs);
  }
  return summary;
}

std::string summaryCsv(const SweepSummary& summary) {
  std::string csv = kSummaryMark;
  for (const auto& [name, share] : kPercentiles) csv += std::string(",") + name;
  csv += ",max";
  for (const ColumnSummary& column : summary.varied) csv += ",r:" + column.name;
  csv += "\n";
  for (const ColumnSummary& column : summary.varied)
    csv += rowOf(column, nullptr, summary.varied.size());
  for (std::size_t k = 0; k < summary.results.size(); ++k)
    csv += rowOf(summary.results[k], &summary.pairs[k], summary.varied.size());
  return csv;
}

std::string summaryTable(const SweepSummary& summary) {
  std::string table = formatted(
      "%lld runs, %lld of them with a result\n  %-34s %11s %10s %11s %11s %11s"
      "  correlation\n",
      static_cast<long long>(summary.rows), static_cast<long long>(summary.done), "", "mean",
      "stddev", "5 %", "median", "95 %");
  for (const ColumnSummary& column : summary.varied)
    if (column.count > 0) table += tableRow(summary, column, std::nullopt);
  // the last two results are the estimated errors
  const std::size_t end = summary.results.size() - 2;
  const std::size_t first = summary.records > 0 ? end - summary.records : 0;
  constexpr std::size_t kMaxRows = 60;
  for (std::size_t k = first; k < std::min(end, first + kMaxRows); ++k)
    if (summary.results[k].count > 0) table += tableRow(summary, summary.results[k], k);
  if (end > first + kMaxRows) table += "  ... summary.csv has the others\n";
  return table;
}

}  // namespace rigid_body_sim
