#pragma once

#include <string>

namespace rigid_body_sim {

/// The number in the fewest digits that read back as the same double, whatever the locale, as
/// shortest() and some ten times as fast: for tables of millions of numbers.
std::string numberText(double x);
void appendNumber(double x, std::string& text);

/// The number that a text is, to its end; none for any other text.
bool readNumberText(const char* begin, const char* end, double& x);

}  // namespace rigid_body_sim
