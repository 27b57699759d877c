#include "usage.hpp"

#include <cmath>
#include <cstdlib>

namespace rigid_body_sim {

double positiveNumber(const std::string& option, const char* text) {
  char* end = nullptr;
  const double x = std::strtod(text, &end);
  if (end == text || *end != '\0' || !std::isfinite(x) || !(x > 0))
    throw UsageError("--" + option + ": must be a finite number > 0, got '" + text + "'");
  return x;
}

}  // namespace rigid_body_sim
