#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "scene/files/number_text.hpp"
#include "scene/message_text.hpp"
#include "tools/common/gnuplot.hpp"
#include "tools/plot/figure.hpp"

namespace rigid_body_sim {
namespace {

// [px]
constexpr double kWidth = 900, kPanel = 190, kHead = 34, kFoot = 60;

// told apart by people who do not see all colours alike (Okabe and Ito)
constexpr const char* kColors[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                   "#e69f00", "#56b4e9", "#7f3c8d", "#000000"};
constexpr std::size_t kColorCount = sizeof kColors / sizeof kColors[0];

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  void take(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

Range timesOf(const Figure& figure) {
  Range range;
  for (const Panel& panel : figure.panels)
    for (const Curve& curve : panel.curves)
      for (const double t : curve.t) range.take(t);
  if (range.low == range.high) range = {range.low - 0.5, range.high + 0.5};
  return range;
}

/// Never of no height, in which gnuplot would find nothing to draw.
Range valuesOf(const Panel& panel) {
  Range range;
  for (const Curve& curve : panel.curves)
    for (const double y : curve.y) range.take(y);
  const double least = std::max(std::abs(range.low), std::abs(range.high));
  const double height = range.high - range.low;
  double room = 0.06 * height;
  if (height <= std::max(1e-9 * panel.scale, 1e-13 * least))
    room = 0.1 * (panel.scale > 0 ? panel.scale : least);
  if (!(range.low - room < range.high + room)) room = 1;
  return {range.low - room, range.high + room};
}

/// A picture has no more columns than these: of more samples, the least and the greatest of each
/// column are drawn. A blank line where time goes back, as after a reset, and where points are
/// missing: there the line breaks.
void writeBlock(const std::string& name, const Curve& curve, std::ostream& script) {
  constexpr std::size_t kColumns = 600;
  const std::size_t count = curve.t.size(), width = std::max<std::size_t>(1, count / kColumns);
  script << name << " << EOD\n";
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  // two points that are drawn are up to two columns apart; rounding of stamps and a short last
  // interval are no gap
  const double gap =
      curve.interval > 0 ? static_cast<double>(2 * width + 2) * curve.interval : kInfinity;
  double last = -kInfinity;
  const auto write = [&](std::size_t k) {
    if (curve.t[k] < last || (last > -kInfinity && curve.t[k] - last > gap)) script << '\n';
    last = curve.t[k];
    script << numberText(last) << ' ' << numberText(curve.y[k]) << '\n';
  };
  for (std::size_t begin = 0; begin < count; begin += width) {
    const auto first = curve.y.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto end = curve.y.begin() + static_cast<std::ptrdiff_t>(std::min(begin + width, count));
    const auto [least, greatest] = std::minmax_element(first, end);
    const auto [one, other] = std::minmax(least, greatest);
    write(static_cast<std::size_t>(one - curve.y.begin()));
    if (one != other) write(static_cast<std::size_t>(other - curve.y.begin()));
  }
  if (width > 1) write(count - 1);
  script << "EOD\n";
}

std::string blockName(std::size_t panel, std::size_t curve) {
  return "$p" + std::to_string(panel) + "c" + std::to_string(curve);
}

std::string shortened(const std::string& name, std::size_t most) {
  std::string line = oneLine(name);
  if (line.size() <= most) return line;
  std::size_t end = most - 3;
  const auto isWithinLetter = [](char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; };
  while (end > 0 && isWithinLetter(line[end])) --end;  // UTF-8
  return line.substr(0, end) + "...";
}

/// A name that leaves room for the plot.
std::string legendText(const std::string& name) { return shortened(name, 20); }

/// As much as the picture is wide.
std::string titleText(const std::string& title) { return shortened(title, 112); }

bool haveTitles(const Figure& figure) {
  return std::any_of(figure.panels.begin(), figure.panels.end(),
                     [](const Panel& panel) { return !panel.title.empty(); });
}

/// Panels of the same curves share the legend of the first.
bool hasLegend(const Figure& figure, std::size_t i) {
  const std::vector<Curve>&first = figure.panels[0].curves, &curves = figure.panels[i].curves;
  return i == 0 || !std::equal(curves.begin(), curves.end(), first.begin(), first.end(),
                               [](const Curve& a, const Curve& b) { return a.name == b.name; });
}

void placePanel(const Figure& figure, std::size_t i, double height, std::ostream& script) {
  const Panel& panel = figure.panels[i];
  const double gap = haveTitles(figure) ? 28 : 14;  // [px]
  const double top = kHead + static_cast<double>(i) * kPanel + gap;
  const double bottom = kHead + static_cast<double>(i + 1) * kPanel;
  const Range values = valuesOf(panel);
  const bool is_last = i + 1 == figure.panels.size();
  script << "set tmargin at screen " << 1 - top / height << "\nset bmargin at screen "
         << 1 - bottom / height << "\nset key at screen 0.775, screen " << 1 - top / height
         << "\nset title " << gnuplotText(panel.title) << " offset 0,-0.6\nset ylabel "
         << gnuplotText(panel.axis) << "\nset yrange [" << numberText(values.low) << ':'
         << numberText(values.high) << "]\n"
         << (is_last ? "set format x '%.8g'\nset xlabel timeaxis\n" : "set format x ''\n");
}

void plotPanel(const Figure& figure, std::size_t i, double height, std::ostream& script) {
  placePanel(figure, i, height, script);
  const Panel& panel = figure.panels[i];
  const bool has_legend = hasLegend(figure, i);
  for (std::size_t k = 0; k < panel.curves.size(); ++k) {
    const Curve& curve = panel.curves[k];
    constexpr std::size_t kFew = 30;
    script << (k == 0 ? "plot " : ", \\\n  ") << blockName(i, k)
           << (curve.t.size() <= kFew ? " with linespoints pt 7 ps 0.5" : " with lines")
           << " lw 1.6 lc rgb '" << kColors[k % kColorCount] << '\''
           << (curve.dashed ? " dt 2" : "");
    if (has_legend && !curve.name.empty())
      script << " title " << gnuplotText(legendText(curve.name));
    else
      script << " notitle";
  }
  script << '\n';
}

std::string scriptOf(const Figure& figure, const std::string& time_axis) {
  const double height = kHead + kFoot + kPanel * static_cast<double>(figure.panels.size());
  const Range times = timesOf(figure);
  std::ostringstream script;
  for (std::size_t i = 0; i < figure.panels.size(); ++i)
    for (std::size_t k = 0; k < figure.panels[i].curves.size(); ++k)
      writeBlock(blockName(i, k), figure.panels[i].curves[k], script);
  script << "set encoding utf8\nset terminal svg size " << kWidth << ',' << height
         << " noenhanced font 'sans,13' background 'white'\ntimeaxis = " << gnuplotText(time_axis)
         << "\nset multiplot title " << gnuplotText(titleText(figure.title))
         << " font ',15'\nset grid lc rgb '#dddddd'\n"
         << "set lmargin at screen 0.12\nset rmargin at screen 0.76\nset format y '%.8g'\n"
         << "set xrange [" << numberText(times.low) << ':' << numberText(times.high) << "]\n"
         << "set ytics nomirror\nset xtics nomirror\n"
         << "set key left top Left reverse samplen 1.5 noenhanced\n";
  for (std::size_t i = 0; i < figure.panels.size(); ++i) plotPanel(figure, i, height, script);
  script << "unset multiplot\n";
  return script.str();
}

}  // namespace

void drawFigure(const Figure& figure, const std::string& time_axis, const std::string& svg) {
  drawByGnuplot(scriptOf(figure, time_axis), svg);
}

}  // namespace rigid_body_sim
