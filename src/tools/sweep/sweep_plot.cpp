#include "tools/sweep/sweep_plot.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>

#include "scene/files/number_text.hpp"
#include "scene/message_text.hpp"
#include "tools/common/gnuplot.hpp"
#include "tools/sweep/table_fields.hpp"
#include "tools/sweep/table_lines.hpp"

namespace rigid_body_sim {
namespace {

/// Whether the values are not so great that their range is none.
bool hasRange(const ColumnSummary& column) {
  return std::isfinite(2 * (column.greatest - column.least));
}

/// Records first, else the place of the first body; those that vary.
std::vector<std::size_t> shownResults(const SweepSummary& summary) {
  constexpr std::size_t kMax = 3;
  std::vector<std::size_t> shown;
  const std::size_t end = summary.results.size() - 2;
  const std::size_t first = summary.records > 0 ? end - summary.records : 0;
  for (std::size_t k = first; k < end && shown.size() < kMax; ++k)
    if (summary.results[k].count > 1 && summary.results[k].least < summary.results[k].greatest &&
        hasRange(summary.results[k]))
      shown.push_back(k);
  return shown;
}

/// How many of the kept numbers lie in each of equal bins: centre and count.
void writeHistogram(const ColumnSummary& column, std::ostream& script) {
  constexpr int kBins = 40;
  const double low = column.least, width = (column.greatest - low) / kBins;
  std::vector<int> counts(kBins);
  for (const double x : column.kept)
    if (!std::isnan(x))
      ++counts[static_cast<std::size_t>(
          std::clamp(std::floor((x - low) / width), 0.0, kBins - 1.0))];
  for (int i = 0; i < kBins; ++i)
    script << numberText(low + (i + 0.5) * width) << ' ' << counts[static_cast<std::size_t>(i)]
           << '\n';
}

void writePoints(const ColumnSummary& x, const ColumnSummary& y, std::ostream& script) {
  constexpr std::size_t kMax = 600;
  for (std::size_t i = 0; i < std::min(y.kept.size(), kMax); ++i)
    if (!std::isnan(x.kept[i]) && !std::isnan(y.kept[i]))
      script << numberText(x.kept[i]) << ' ' << numberText(y.kept[i]) << '\n';
}

/// The instants of the fan and percentiles of the quantity there: time, 5, 25, 50, 75, 95 %.
/// Returns what all of it is like; of no values, where there is none.
ColumnSummary writeFan(const std::string& fan_csv, std::ostream& script) {
  TableLines lines(fan_csv);
  std::string header, line;
  std::vector<std::string_view> times, fields;
  ColumnSummary all;
  if (!lines.next(header, std::string::npos)) return all;
  splitFields(header, times);
  std::vector<ColumnSummary> columns(times.size());  // that of the run stays empty
  const std::size_t longest = longestRow(header);
  while (lines.next(line, longest)) {
    splitFields(line, fields);
    for (std::size_t k = 1; k < std::min(columns.size(), fields.size()); ++k) {
      double x = 0;
      if (!readNumberText(fields[k].data(), fields[k].data() + fields[k].size(), x)) continue;
      columns[k].kept.push_back(x);
      all.add(x);
    }
  }
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (columns[k].kept.empty()) continue;
    script << times[k];
    for (double share : {0.05, 0.25, 0.5, 0.75, 0.95})
      script << ' ' << numberText(columns[k].percentile(share));
    script << '\n';
  }
  return all;
}

/// Between tics, so that three or four stand on an axis: more would overlap where numbers are long.
double ticStep(const ColumnSummary& column) {
  const double range = column.greatest - column.least;
  const double power = std::pow(10, std::floor(std::log10(range / 2)));
  const double digit = range / 2 / power;
  return power * (digit < 2 ? 1 : digit < 5 ? 2 : 5);
}

void setTics(char axis, const ColumnSummary& column, std::ostream& script) {
  script << "set " << axis << "tics nomirror ";
  if (column.least < column.greatest)
    script << numberText(ticStep(column)) << "\n";
  else
    script << "autofreq\n";
}

void plotResult(const SweepSummary& summary, std::size_t k, std::size_t place, std::size_t count,
                std::ostream& script) {
  const double width = 1.0 / static_cast<double>(count), left = static_cast<double>(place) * width;
  const std::string name = summary.results[k].name;
  setTics('x', summary.results[k], script);
  script << "set ytics nomirror autofreq\nset size " << width << ",0.33\nset origin " << left
         << ",0.62\n"
         << "set xlabel " << gnuplotText(name) << "\nset ylabel 'runs'\nset yrange [0:*]\n"
         << "plot $histogram" << k << " with boxes lc rgb '#4682b4' notitle\n"
         << "set yrange [*:*]\n";
  const auto most = summary.mostCorrelated(k);
  if (!most) return;
  setTics('x', summary.varied[*most], script);
  setTics('y', summary.results[k], script);
  script << "set origin " << left << ",0.31\nset xlabel "
         << gnuplotText(oneLine(summary.varied[*most].name)) << "\nset ylabel " << gnuplotText(name)
         << "\nplot $points" << k << " with points pt 7 ps 0.25 lc rgb '#4682b4' notitle\n";
}

void plotFan(const SweepInfo& info, const ColumnSummary& all, std::ostream& script) {
  // gnuplot warns of a range of nothing
  if (all.least == all.greatest)
    script << "set yrange [" << numberText(all.least - 1) << ":" << numberText(all.greatest + 1)
           << "]\n";
  script << "set xtics nomirror autofreq\nset ytics nomirror autofreq\nset size 1,0.31\nset origin "
            "0,0\nset xlabel 'time "
            "[s]'\nset ylabel "
         << gnuplotText(info.fan) << "\nset key outside right\n"
         << "plot $fan using 1:2:6 with filledcurves lc rgb '#d6e4f0' title '5 to 95 %', \\\n"
         << "  $fan using 1:3:5 with filledcurves lc rgb '#9dbfdd' title '25 to 75 %', \\\n"
         << "  $fan using 1:4 with lines lw 2 lc rgb '#1f4e79' title 'median'\n";
}

}  // namespace

std::string sweepPlot(const SweepSummary& summary, const SweepInfo& info,
                      const std::string& fan_csv) {
  std::ostringstream script;
  const std::vector<std::size_t> shown = shownResults(summary);
  for (const std::size_t k : shown) {
    script << "$histogram" << k << " << EOD\n";
    writeHistogram(summary.results[k], script);
    script << "EOD\n";
    if (const auto most = summary.mostCorrelated(k)) {
      script << "$points" << k << " << EOD\n";
      writePoints(summary.varied[*most], summary.results[k], script);
      script << "EOD\n";
    }
  }
  std::ostringstream fan;
  ColumnSummary all_of_fan;
  if (!info.fan.empty()) all_of_fan = writeFan(fan_csv, fan);
  const bool has_fan = all_of_fan.count > 0 && hasRange(all_of_fan);
  if (has_fan) script << "$fan << EOD\n" << fan.str() << "EOD\n";
  script << "set terminal svg size 1000,900 name 'rigid_body_sim_sweep' noenhanced font 'sans,13' "
            "background 'white'\n"
         << "set multiplot title "
         << gnuplotText(oneLine(info.title) + ": " + std::to_string(summary.done) + " runs") << "\n"
         << "set grid lc rgb '#dddddd'\nset style fill solid noborder\nset boxwidth 0.9 relative\n"
         << "set xtics nomirror autofreq\nset format '%g'\n";
  for (std::size_t i = 0; i < shown.size(); ++i)
    plotResult(summary, shown[i], i, shown.size(), script);
  if (has_fan) plotFan(info, all_of_fan, script);
  script << "unset multiplot\n";
  return drawnByGnuplot(script.str(), "sweep.svg");
}

}  // namespace rigid_body_sim
