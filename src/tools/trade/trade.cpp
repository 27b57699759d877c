#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>

#include "programs/distinct_files.hpp"
#include "programs/formatted.hpp"
#include "programs/make_directory.hpp"
#include "programs/run_program.hpp"
#include "programs/standard_streams.hpp"
#include "programs/step_watch.hpp"
#include "programs/tool_scene.hpp"
#include "programs/usage.hpp"
#include "tools/common/gnuplot.hpp"
#include "tools/common/progress_bar.hpp"
#include "tools/trade/trade_contact.hpp"
#include "tools/trade/trade_ladder.hpp"
#include "tools/trade/trade_options.hpp"
#include "tools/trade/trade_plot.hpp"
#include "tools/trade/trade_report.hpp"
#include "tools/trade/trade_write.hpp"

namespace rigid_body_sim {
namespace {

using Climb = decltype(climbLadder);

/// Where the share of the work that is done is shown: a bar on terminals, a word after a while.
struct Progress {
  void show(double share) {
    bar.show(share);
    watch.goOn(share);
  }

  static std::string what(double share) {
    if (share == 0)
      return "led to a reference that settings can be measured against: the motion is fast, or the "
             "processor "
             "is busy";
    return formatted(
        "measured more than some %.0f %% of the settings: the motion is fast, or the processor is "
        "busy",
        100 * share);
  }

  ProgressBar bar{};
  StepWatch watch{[](const std::string& text) {
                    std::fprintf(stderr, "%s\n", noticeLine("trade", text).c_str());
                  },
                  10, what};
};

/// Every setting of every integrator, each written as soon as it is known.
std::vector<Setting> measureAll(const World& world, const Reference& reference,
                                const std::vector<std::string>& integrators, Climb& climb,
                                TradeCsv& csv, Progress& progress) {
  constexpr double kUsualLadder = 16;  // settings; for the bar only
  std::vector<Setting> settings;
  const auto count = static_cast<double>(integrators.size());
  for (std::size_t i = 0; i < integrators.size(); ++i) {
    double done = 0;
    const auto measured = [&](const Setting& setting) {
      csv.write(setting);
      settings.push_back(setting);
      done = std::min(1.0, done + 1 / kUsualLadder);
      progress.show((1 + static_cast<double>(i) + done) / (1 + count));
    };
    climb(world, reference, integrators[i], measured, Patience{});
  }
  return settings;
}

/// By integrators in the order of the catalogue, each by ascending step and tolerance.
void sortLadders(std::vector<Setting>& settings) {
  for (auto begin = settings.begin(); begin != settings.end();) {
    const auto end = std::find_if(
        begin, settings.end(), [&](const Setting& s) { return s.integrator != begin->integrator; });
    std::sort(begin, end, [](const Setting& a, const Setting& b) {
      return std::tie(a.time_step, a.tolerance) < std::tie(b.time_step, b.tolerance);
    });
    begin = end;
  }
}

/// files: what is read of the scene.
void requireDistinctFiles(const TradeOptions& options, std::vector<NamedFile> files) {
  files.push_back({"the table", options.out + "/trade.csv", true});
  files.push_back({"the plot", options.out + "/trade.svg", true});
  requireDistinct(files);
}

Trade measureTrade(const TradeOptions& options) {
  requireDistinctFiles(options, filesOfScene(options.scene, {}));
  const Scene scene = loadToolScene(options.scene);
  requireDistinctFiles(options, filesOfScene(scene.source, scene.files));
  const double duration = options.duration.value_or(scene.horizon);
  requireCountable(duration, scene.time_step, "steps");
  const World world = buildWorld(scene);
  const State first = initialState(scene, world);
  const bool contact = hasContact(world);
  const std::vector<std::string> integrators =
      contact ? std::vector<std::string>{"auto"} : integratorsFor(world, first);
  makeDirectory(options.out);
  TradeCsv csv(options.out + "/trade.csv", contact);
  for (const std::string& notice : scene.notices)
    std::fprintf(stderr, "%s\n", noticeLine("trade", notice).c_str());

  Progress progress;
  progress.show(0);
  progress.watch.begin(0);
  Trade trade;
  trade.scene = options.scene;
  trade.present = world.solver;
  trade.error_budget = options.error_budget.value_or(scene.tolerance);
  trade.reference = contact ? contactReference(world, first, duration, trade.error_budget)
                            : computeReference(world, first, duration);
  progress.show(1 / (1 + static_cast<double>(integrators.size())));
  trade.settings = measureAll(world, trade.reference, integrators,
                              contact ? climbTolerances : climbLadder, csv, progress);
  sortLadders(trade.settings);
  return trade;
}

void writeRecommended(const Trade& trade) {
  const Setting* best = recommended(trade);
  if (!best) throw std::runtime_error(trade.scene + ": left as it was");
  if (isPresent(*best, trade.present)) return;
  print(writeSolver(trade.scene, best->integrator, best->time_step, best->tolerance) + "\n");
}

void run(const TradeOptions& options) {
  const Trade trade = measureTrade(options);
  print(tableText(trade) + referenceText(trade.reference) + adviceText(trade));
  if (options.write) writeRecommended(trade);
  const std::string there = options.out + "/trade.csv is there",
                    fault = pictureFault(trade.settings);
  if (!fault.empty())
    print("no picture: " + fault + "; " + there + "\n");
  else if (hasGnuplot())
    plotTrade(trade, options.out + "/trade.svg");
  else
    print(gnuplotIsMissing(there) + "\n");
}

}  // namespace
}  // namespace rigid_body_sim

int main(int argc, char** argv) {
  using namespace rigid_body_sim;
  return runProgram("trade", [&] {
    const TradeOptions options = parseTradeOptions(argc, argv);
    if (options.help)
      print(tradeHelp());
    else
      run(options);
  });
}
