#pragma once

#include <string>

namespace rigid_body_sim {

/// Whether the program that draws is installed.
bool hasGnuplot();

/// A line for the user where it is not. there: what holds the numbers that would have been drawn,
/// such as "runs.csv is there".
std::string gnuplotIsMissing(const std::string& there);

/// A directory for pictures, from the command line. Throws UsageError for a path that gnuplot does
/// not take: it must not have line ends in it. what: such as "--out".
std::string pictureDirectory(const std::string& what, const std::string& path);

/// The SVG that gnuplot draws by a script, whole. Throws std::runtime_error, which says the name of
/// the picture. Nothing is left of it in any file, whenever the process is ended.
std::string drawnByGnuplot(const std::string& script, const std::string& name);

/// The same, written to a file, which stays as it was where that fails.
void drawByGnuplot(const std::string& script, const std::string& picture);

/// As gnuplot reads a text of one line word for word: in double quotes it would run what stands in
/// backquotes.
std::string gnuplotText(const std::string& text);

}  // namespace rigid_body_sim
