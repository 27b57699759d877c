#include "tools/trade/trade_plot.hpp"

#include <filesystem>
#include <sstream>

#include "scene/message_text.hpp"
#include "tools/common/gnuplot.hpp"

namespace rigid_body_sim {
namespace {

/// A named block of points (processor time [us/s], error); an error of zero has no place on a log
/// scale.
template <class Keep>
void writeBlock(const std::string& name, const std::vector<Setting>& settings, const Keep& keep,
                std::ostream& script) {
  constexpr double kLeast = 1e-17;
  script << name << " << EOD\n";
  for (const Setting& s : settings)
    if (keep(s) && canBeDrawn(s))
      script << 1e-3 * s.cpu_ns_per_sim_s << ' ' << std::max(s.errors.bounded(), kLeast) << '\n';
  script << "EOD\n";
}

std::vector<std::string> namesOf(const std::vector<Setting>& settings) {
  std::vector<std::string> names;
  for (const Setting& s : settings)
    if (names.empty() || names.back() != s.integrator) names.push_back(s.integrator);
  return names;
}

std::string scriptOf(const Trade& trade) {
  std::ostringstream script;
  const std::vector<std::string> names = namesOf(trade.settings);
  for (std::size_t i = 0; i < names.size(); ++i)
    writeBlock(
        "$integrator" + std::to_string(i), trade.settings,
        [&](const Setting& s) { return s.integrator == names[i]; }, script);
  const auto all = [](const Setting&) { return true; };
  writeBlock("$front", paretoFront(trade.settings, trade.reference), all, script);
  writeBlock(
      "$present", trade.settings, [&](const Setting& s) { return isPresent(s, trade.present); },
      script);
  const std::string scene = std::filesystem::path(trade.scene).filename().string();
  script << "set terminal svg size 900,600 noenhanced font 'sans,14' background 'white'\n"
         << "set title " << gnuplotText("What accuracy costs: " + oneLine(scene)) << "\n"
         << "set xlabel 'processor time per simulated second [us]'\n"
         << "set ylabel 'worst error: attitude [rad] or position / path'\n"
         << "set logscale xy\nset format x '10^{%L}'\nset format y '10^{%L}'\n"
         << "set termoption enhanced\nset grid lc rgb '#dddddd'\nset key outside right noenhanced\n"
         << "set title noenhanced\nset linetype 5 lc rgb '#b8860b'\n"
         << "plot $front with lines lw 9 lc rgb '#d8d8d8' title 'Pareto front', \\\n";
  for (std::size_t i = 0; i < names.size(); ++i)
    script << "  $integrator" << i << " with linespoints lw 1.5 ps 0.6 pt 7 lt " << i + 1
           << " title " << gnuplotText(names[i]) << ", \\\n";
  script << "  " << trade.error_budget
         << " with lines dt 2 lc rgb 'black' title 'error budget', \\\n"
         << "  $present with points pt 6 ps 2.5 lw 3 lc rgb 'black' title 'the scene now'\n";
  return script.str();
}

}  // namespace

void plotTrade(const Trade& trade, const std::string& svg_path) {
  drawByGnuplot(scriptOf(trade), svg_path);
}

}  // namespace rigid_body_sim
