#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tools/sweep/sweep_info.hpp"

namespace rigid_body_sim {

/// What is known of one column of numbers.
struct ColumnSummary {
  std::string name;
  std::int64_t count = 0;  ///< of numbers; fields may be empty
  double mean = 0, m2 = 0, least = 0, greatest = 0;
  std::vector<double> kept;  ///< in the order of the runs, not a number where there is none

  void add(double x);
  double stddev() const;  ///< of the distribution; 0 of fewer than two

  /// Of the values kept, 0 <= share <= 1, between the two nearest; not a number of none.
  double percentile(double share) const;

 private:
  mutable std::vector<double> sorted_;
};

/// Sums over the pairs of a column of results and a varied one.
struct PairSummary {
  std::int64_t count = 0;
  double mean_x = 0, mean_y = 0, m2_x = 0, m2_y = 0, covariance = 0;

  void add(double x, double y);

  /// Pearson's; none where one of them is constant.
  std::optional<double> correlation() const;
};

/// What the rows of a sweep say: in memory that does not grow with them.
struct SweepSummary {
  /// Rows whose values are kept for percentiles and plots; means, deviations, extremes and
  /// correlations are of all.
  static constexpr std::size_t kKeptRows = 100000;

  std::int64_t rows = 0, done = 0;  ///< in all; with results
  std::uint64_t digest = 0;         ///< of the rows
  std::vector<ColumnSummary> varied, results;
  std::vector<std::vector<PairSummary>> pairs;  ///< by result, by varied column
  std::size_t records = 0;                      ///< of the results: the last

  /// Of the table, with the run and its status.
  std::size_t columns() const { return varied.size() + results.size() + 2; }

  /// The varied column that a result goes most with; none where it goes with none.
  std::optional<std::size_t> mostCorrelated(std::size_t result) const;
};

/// Reads runs.csv. Throws std::runtime_error for a file that is none.
SweepSummary summarise(const std::string& path, const SweepInfo& info);

/// With which summary.csv begins.
constexpr const char* kSummaryMark = "column,count,mean,stddev,min";

/// summary.csv, and the table for a terminal: varied values, and records or, without any, end
/// states.
std::string summaryCsv(const SweepSummary& summary);
std::string summaryTable(const SweepSummary& summary);

}  // namespace rigid_body_sim
