#pragma once

#include <string>

namespace rigid_body_sim {

/// Whether the program that draws is installed.
bool hasGnuplot();

/// Gives gnuplot a script. Throws std::runtime_error, which names the picture, where it fails.
void runGnuplot(const std::string& script, const std::string& picture);

/// As gnuplot reads a text of one line word for word: in double quotes it would run what stands in
/// backquotes.
std::string gnuplotText(const std::string& text);

}  // namespace rigid_body_sim
