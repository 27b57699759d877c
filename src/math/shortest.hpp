#pragma once

#include <limits>
#include <locale>
#include <sstream>
#include <string>

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

/// The number in the fewest digits that read back as the same double, whatever the locale.
inline std::string shortest(double x) {
  std::string text;
  for (int digits = 15; digits <= std::numeric_limits<double>::max_digits10; ++digits) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out.precision(digits);
    out << x;
    text = out.str();
    std::istringstream in(text);
    in.imbue(std::locale::classic());
    double back = 0;
    if (in >> back && back == x) break;
  }
  return text;
}

/// "[x y z]", each in the fewest digits.
inline std::string shortest(const Vector3d& v) {
  return "[" + shortest(v.x()) + " " + shortest(v.y()) + " " + shortest(v.z()) + "]";
}

}  // namespace rigid_body_sim
