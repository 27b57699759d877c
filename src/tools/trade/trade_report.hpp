#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "tools/trade/trade_setting.hpp"

namespace rigid_body_sim {

/// trade.csv, a row as soon as it is known.
class TradeCsv {
 public:
  /// Writes the header; tolerances: with a last column for them. Throws std::runtime_error where
  /// the file cannot be written.
  TradeCsv(const std::string& path, bool tolerances);
  ~TradeCsv();
  TradeCsv(const TradeCsv&) = delete;
  TradeCsv& operator=(const TradeCsv&) = delete;

  /// Throws std::runtime_error where the row does not reach the file.
  void write(const Setting& setting);

 private:
  void flush();

  std::string path_;
  bool tolerances_;
  std::FILE* file_;
};

/// Everything that a run of `trade` found out.
struct Trade {
  std::string scene;  ///< file
  Reference reference;
  SolverOptions present;          ///< what the scene says now
  double error_budget = 0;        ///< [rad, relative]
  std::vector<Setting> settings;  ///< by integrator, by ascending step and tolerance
};

/// Whether a setting is what the scene says now.
bool isPresent(const Setting& setting, const SolverOptions& present);

/// How far the reference can be trusted: a line of text.
std::string referenceText(const Reference& reference);

/// The table of settings, with a legend.
std::string tableText(const Trade& trade);

/// The setting of the least work within the budget, or within twice what the reference is known to
/// if that is more; null if there is none.
const Setting* recommended(const Trade& trade);

/// The recommended setting, as lines of a scene file, and what to do with them; or that there is
/// none.
std::string adviceText(const Trade& trade);

}  // namespace rigid_body_sim
