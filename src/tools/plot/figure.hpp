#pragma once

#include <string>
#include <vector>

namespace rigid_body_sim {

/// A line of a plot.
struct Curve {
  std::string name;  ///< in the legend
  std::vector<double> t{}, y{};
  bool dashed = false;  ///< so that a line below it can be seen
  /// [s] The usual interval between two points. Where points are missing, as of a body that was
  /// absent, the line breaks. Zero: it never does.
  double interval = 0;
};

/// Curves over one axis.
struct Panel {
  std::string title;  ///< may be empty
  std::string axis;   ///< what is drawn, with its unit in brackets
  std::vector<Curve> curves;
  /// What counts as a change: a panel whose values differ by less than a billionth of it is drawn
  /// as a straight line, not as the rounding in it. Zero: every difference counts.
  double scale = 0;
};

/// A picture: panels below one another over the same time.
struct Figure {
  std::string name;   ///< of the file, without its extension
  std::string title;  ///< in plain words
  std::vector<Panel> panels;
};

/// Draws a figure as an SVG file. time_axis: its label, with the unit. Throws std::runtime_error,
/// the path first, where the file cannot be written or gnuplot fails.
void drawFigure(const Figure& figure, const std::string& time_axis, const std::string& svg);

}  // namespace rigid_body_sim
