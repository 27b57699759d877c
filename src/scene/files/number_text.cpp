#include "scene/files/number_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include <double-conversion/double-conversion.h>

namespace rigid_body_sim {
namespace {

/// The fewest digits that read back as the same double: digits[0].digits[1]… × 10^exponent.
struct Decimal {
  char digits[32];
  int count = 0;
  int exponent = 0;
};

#if defined(__cpp_lib_to_chars)  // of GCC 11 on: the same digits in a quarter of the time
Decimal decimalOf(double magnitude) {
  char text[32];
  const char* const end =
      std::to_chars(text, text + sizeof text, magnitude, std::chars_format::scientific).ptr;
  Decimal decimal;
  const char* c = text;
  for (; *c != 'e'; ++c)
    if (*c != '.') decimal.digits[decimal.count++] = *c;
  c += c[1] == '+' ? 2 : 1;  // from_chars takes no plus
  std::from_chars(c, end, decimal.exponent);
  return decimal;
}
#else
Decimal decimalOf(double magnitude) {
  using double_conversion::DoubleToStringConverter;
  Decimal decimal;
  bool negative = false;
  DoubleToStringConverter::DoubleToAscii(magnitude, DoubleToStringConverter::SHORTEST, 0,
                                         decimal.digits, sizeof decimal.digits, &negative,
                                         &decimal.count, &decimal.exponent);
  --decimal.exponent;  // it puts the point before the first digit
  return decimal;
}
#endif

void appendDecimal(const Decimal& decimal, std::string& text) {
  const int count = decimal.count, exponent = decimal.exponent;
  const auto put = [&](int from, int to) {
    if (to > from) text.append(decimal.digits + from, static_cast<std::size_t>(to - from));
  };
  const auto zeros = [&](int n) {
    if (n > 0) text.append(static_cast<std::size_t>(n), '0');
  };
  if (exponent < -5 || exponent >= 17) {
    put(0, 1);
    if (count > 1) text += '.';
    put(1, count);
    text += 'e';
    text += std::to_string(exponent);
  } else if (exponent < 0) {
    text += "0.";
    zeros(-exponent - 1);
    put(0, count);
  } else {
    put(0, std::min(count, exponent + 1));
    zeros(exponent + 1 - count);
    if (count > exponent + 1) text += '.';
    put(exponent + 1, count);
  }
}

}  // namespace

void appendNumber(double x, std::string& text) {
  if (std::isnan(x)) {
    text += "nan";
    return;
  }
  if (std::signbit(x)) text += '-';
  if (std::isinf(x))
    text += "inf";
  else
    appendDecimal(decimalOf(std::abs(x)), text);
}

std::string numberText(double x) {
  std::string text;
  appendNumber(x, text);
  return text;
}

bool readNumberText(const char* begin, const char* end, double& x) {
  using double_conversion::StringToDoubleConverter;
#if defined(_GLIBCXX_RELEASE) && _GLIBCXX_RELEASE >= 12  // the same number in a third of the time
  const auto [rest, error] = std::from_chars(begin, end, x);
  if (error == std::errc() && rest == end && std::isfinite(x)) return true;
#endif
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  static const StringToDoubleConverter converter(StringToDoubleConverter::NO_FLAGS, kNone, kNone,
                                                 "inf", "nan");
  int taken = 0;
  x = converter.StringToDouble(begin, static_cast<int>(end - begin), &taken);
  return begin != end && taken == end - begin;
}

}  // namespace rigid_body_sim
