#pragma once

#include <string>

namespace rigid_body_sim {

/// Whether the program that draws is installed.
bool hasGnuplot();

/// A line for the user where it is not. there: what holds the numbers that would have been drawn,
/// such as "runs.csv is there".
std::string gnuplotIsMissing(const std::string& there);

/// A directory for pictures, from the command line. Throws UsageError for a path that gnuplot does
/// not take: it must not be empty, nor have line ends in it. option: without its dashes.
std::string pictureDirectory(const std::string& option, const std::string& path);

/// Gives gnuplot a script. Throws std::runtime_error, which names the picture, where it fails,
/// and leaves none then.
void runGnuplot(const std::string& script, const std::string& picture);

/// What gnuplot writes to its standard output by a script: an SVG that is whole. Throws
/// std::runtime_error, which says the name of the picture. Nothing is left of it in any file,
/// whenever the process is ended.
std::string drawnByGnuplot(const std::string& script, const std::string& name);

/// As gnuplot reads a text of one line word for word: in double quotes it would run what stands in
/// backquotes.
std::string gnuplotText(const std::string& text);

}  // namespace rigid_body_sim
