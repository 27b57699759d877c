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
  char text[32];
  const char* digits = text;  // within the text
  int count = 0;
  int exponent = 0;
};

#if defined(__cpp_lib_to_chars)  // of GCC 11 on: the same digits in a quarter of the time
void setDecimal(double magnitude, Decimal& decimal) {
  char* const text = decimal.text;
  char* const end =
      std::to_chars(text, text + sizeof decimal.text, magnitude, std::chars_format::scientific).ptr;
  // d.ddde-07 or de+123: the point makes way for the digit before it
  char* c = end;
  while (c[-1] != 'e') --c;
  decimal.count = text[1] == '.' ? static_cast<int>(c - text) - 2 : 1;
  if (decimal.count > 1) text[1] = text[0];
  decimal.digits = text + (decimal.count > 1);
  const bool negative = *c++ == '-';
  int size = 0;
  for (; c < end; ++c) size = 10 * size + (*c - '0');
  decimal.exponent = negative ? -size : size;
}
#else
void setDecimal(double magnitude, Decimal& decimal) {
  using double_conversion::DoubleToStringConverter;
  bool negative = false;
  DoubleToStringConverter::DoubleToAscii(magnitude, DoubleToStringConverter::SHORTEST, 0,
                                         decimal.text, sizeof decimal.text, &negative,
                                         &decimal.count, &decimal.exponent);
  --decimal.exponent;  // it puts the point before the first digit
}
#endif

/// Puts the number at `to`, where there is room for 64 characters; returns its end.
char* putDecimal(const Decimal& decimal, char* to) {
  const int count = decimal.count, exponent = decimal.exponent;
  const auto put = [&](int from, int end) {
    if (end > from) to = std::copy(decimal.digits + from, decimal.digits + end, to);
  };
  const auto zeros = [&](int n) {
    if (n > 0) to = std::fill_n(to, n, '0');
  };
  if (exponent < -5 || exponent >= 17) {
    put(0, 1);
    if (count > 1) *to++ = '.';
    put(1, count);
    *to++ = 'e';
    return std::to_chars(to, to + 8, exponent).ptr;
  }
  if (exponent < 0) {
    *to++ = '0';
    *to++ = '.';
    zeros(-exponent - 1);
    put(0, count);
    return to;
  }
  put(0, std::min(count, exponent + 1));
  zeros(exponent + 1 - count);
  if (count > exponent + 1) *to++ = '.';
  put(exponent + 1, count);
  return to;
}

}  // namespace

void appendNumber(double x, std::string& text) {
  if (std::isnan(x)) {
    text += "nan";
    return;
  }
  if (std::isinf(x)) {
    text += x < 0 ? "-inf" : "inf";
    return;
  }
  char number[64];
  char* to = number;
  if (std::signbit(x)) *to++ = '-';
  Decimal decimal;
  setDecimal(std::abs(x), decimal);
  to = putDecimal(decimal, to);
  text.append(number, static_cast<std::size_t>(to - number));
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
