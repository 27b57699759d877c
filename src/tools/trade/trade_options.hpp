#pragma once

#include <optional>
#include <string>

namespace rigid_body_sim {

/// What the command line of `trade` says; absent means as the scene says.
struct TradeOptions {
  std::string scene;
  std::optional<double> duration;      ///< [s] > 0
  std::optional<double> error_budget;  ///< > 0
  std::string out = ".";               ///< directory
  bool write = false;                  ///< the recommended setting, into the scene file
  bool help = false;
};

/// Throws UsageError for an unknown option, a value that is no number > 0, or no scene.
TradeOptions parseTradeOptions(int argc, char** argv);

/// The text of --help.
std::string tradeHelp();

}  // namespace rigid_body_sim
