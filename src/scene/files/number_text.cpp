#include "scene/files/number_text.hpp"

#include <limits>

#include <double-conversion/double-conversion.h>

namespace rigid_body_sim {

void appendNumber(double x, std::string& text) {
  using double_conversion::DoubleToStringConverter;
  static const DoubleToStringConverter converter(DoubleToStringConverter::NO_FLAGS, "inf", "nan",
                                                 'e', -5, 17, 0, 0);
  constexpr int kRoom = 40;
  char buffer[kRoom];
  double_conversion::StringBuilder builder(buffer, kRoom);
  converter.ToShortest(x, &builder);
  const auto length = static_cast<std::size_t>(builder.position());
  text.append(builder.Finalize(), length);
}

std::string numberText(double x) {
  std::string text;
  appendNumber(x, text);
  return text;
}

bool readNumberText(const char* begin, const char* end, double& x) {
  using double_conversion::StringToDoubleConverter;
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  static const StringToDoubleConverter converter(StringToDoubleConverter::NO_FLAGS, kNone, kNone,
                                                 "inf", "nan");
  int taken = 0;
  x = converter.StringToDouble(begin, static_cast<int>(end - begin), &taken);
  return begin != end && taken == end - begin;
}

}  // namespace rigid_body_sim
