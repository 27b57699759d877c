#include "tools/plot/run_data.hpp"

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>

#include "math/shortest.hpp"
#include "scene/files/read_file.hpp"
#include "scene/message_text.hpp"
#include "tools/common/csv_header.hpp"
#include "tools/common/csv_rows.hpp"
#include "tools/common/require_motion.hpp"

namespace rigid_body_sim {
namespace {

template <std::size_t N>
void addSample(double t, const std::vector<double>& numbers, Samples<N>& samples) {
  std::array<double, N> row;
  std::copy(numbers.begin(), numbers.end(), row.begin());
  samples.t.push_back(t);
  samples.rows.push_back(row);
}

template <class Rows>
void requireFirstOfItsKind(const Rows& rows) {
  if (!rows.empty())
    throw std::runtime_error("another file of the same kind is given, too: plot one run at a time");
}

std::string readMotionRows(std::istream& file, const std::string& header, RunData& run) {
  requireFirstOfItsKind(run.motion);
  return readCsvRows(file, header, [&](const CsvRow& row) {
    Samples<13>& samples = run.motion.of(row.body);
    addSample(row.time, row.numbers, samples);
    requireMotion(samples.rows.back());
  });
}

std::string readForceRows(std::istream& file, const std::string& header, RunData& run) {
  requireFirstOfItsKind(run.loads);
  return readCsvRows(file, header, [&](const CsvRow& row) {
    addSample(row.time, row.numbers, run.loads.of(row.body));
  });
}

std::string readBalanceRows(std::istream& file, const std::string& header, RunData& run) {
  requireFirstOfItsKind(run.balance.t);
  run.has_kinetic = true;
  return readCsvRows(file, header,
                     [&](const CsvRow& row) { addSample(row.time, row.numbers, run.balance); });
}

std::string readRows(std::istream& file, RunData& run) {
  std::string header;
  readCsvLine(file, header);
  if (header == kCsvHeader) return readMotionRows(file, header, run);
  if (header == kForcesHeader) return readForceRows(file, header, run);
  if (header == kBalanceHeader) return readBalanceRows(file, header, run);
  throw std::runtime_error(
      "neither a bag (.bag) nor a CSV file that simulate writes with --csv or --plot: line 1 is '" +
      printable(header) + "'");
}

void addCsv(const std::string& path, RunData& run) {
  std::error_code none;
  if (std::filesystem::is_directory(path, none))
    throw std::runtime_error("is a directory; plot takes the files in it, by their names");
  std::ifstream file(path);
  if (!file.is_open()) throw std::runtime_error(openFault(path, errno));
  const std::string cut = readRows(file, run);
  if (!cut.empty()) run.notices.push_back(oneLine(path) + ": " + cut + "; it is not drawn");
}

/// The first instant that lies before that of the row above it; none where time goes on.
template <std::size_t N>
std::optional<double> firstStepBack(const Samples<N>& samples) {
  const auto up_to = std::is_sorted_until(samples.t.begin(), samples.t.end());
  return up_to == samples.t.end() ? std::nullopt : std::optional<double>(*up_to);
}

void noteStepsBack(RunData& run) {
  std::optional<double> back = firstStepBack(run.balance);
  for (const auto& body : run.motion.all())
    if (!back) back = firstStepBack(body.samples);
  for (const auto& body : run.loads.all())
    if (!back) back = firstStepBack(body.samples);
  if (back)
    run.notices.push_back("rows run backwards in time, first at " + shortest(*back) +
                          " s: lines follow the rows; sort them, or plot one run at a time");
}

std::string fileName(const std::string& path) {
  return oneLine(std::filesystem::path(path).filename().string());
}

/// One file by its name, several by their directory.
std::string nameOf(const std::vector<std::string>& paths) {
  if (paths.size() == 1) return fileName(paths[0]);
  const std::filesystem::path full = std::filesystem::absolute(paths[0]).lexically_normal();
  return fileName(full.parent_path().string());
}

bool isEmpty(const RunData& run) {
  return run.motion.empty() && run.loads.empty() && run.balance.t.empty();
}

}  // namespace

RunData readRun(const std::vector<std::string>& paths) {
  RunData run;
  for (const std::string& path : paths) try {
      if (isBag(path) && paths.size() > 1)
        throw std::runtime_error("a bag is plotted alone, without other files");
      if (isBag(path))
        run = readBagRun(path);
      else
        addCsv(path, run);
    } catch (const std::exception& error) {
      throw std::runtime_error(oneLine(path) + ": " + error.what());
    }
  if (isEmpty(run)) throw std::runtime_error(oneLine(paths[0]) + ": holds no rows");
  if (!isBag(paths[0])) noteStepsBack(run);
  run.name = nameOf(paths);
  return run;
}

}  // namespace rigid_body_sim
