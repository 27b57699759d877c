#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "scene/files/number_text.hpp"

namespace rigid_body_sim {
namespace {

/// Digits and power of ten, by the C library: the first precision that reads back.
std::string scientific(double x) {
  char text[40];
  for (int precision = 0; precision < 17; ++precision) {
    std::snprintf(text, sizeof text, "%.*e", precision, x);
    if (std::strtod(text, nullptr) == x) break;
  }
  return text;
}

/// A decimal text in that form.
std::string asScientific(const std::string& decimal) {
  const std::string mantissa = decimal.substr(0, decimal.find('e'));
  const auto digits =
      std::count_if(mantissa.begin(), mantissa.end(), [](char c) { return c >= '0' && c <= '9'; });
  const std::size_t first = mantissa.find_first_of("123456789");
  std::string all;
  for (const char c : mantissa.substr(first))
    if (c != '.') all += c;
  while (all.size() > 1 && all.back() == '0') all.pop_back();
  EXPECT_LE(digits, 22) << decimal;
  char text[40];
  std::snprintf(text, sizeof text, "%.*e", static_cast<int>(all.size()) - 1,
                std::strtod(decimal.c_str(), nullptr));
  return text;
}

}  // namespace

TEST(NumberText, HasTheFewestDigitsThatReadBack) {
  std::mt19937_64 rng(3);
  std::uniform_real_distribution<double> everyday(-50, 50);
  for (int i = 0; i < 20000; ++i) {
    const std::uint64_t bits = rng();
    double x = 0;
    std::memcpy(&x, &bits, sizeof x);
    if (i % 2 == 0) x = everyday(rng);
    if (!std::isfinite(x)) continue;
    const std::string text = numberText(x);
    ASSERT_EQ(std::strtod(text.c_str(), nullptr), x) << text;
    ASSERT_EQ(asScientific(text), scientific(x)) << text;
  }
}

TEST(NumberText, WritesAPowerOfTenOnlyWhereZerosWouldBeMany) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  const std::pair<double, const char*> cases[] = {{0, "0"},
                                                  {-0.0, "-0"},
                                                  {1, "1"},
                                                  {-2.5, "-2.5"},
                                                  {100, "100"},
                                                  {0.1, "0.1"},
                                                  {1e-5, "0.00001"},
                                                  {-1.5e-5, "-0.000015"},
                                                  {1e-6, "1e-6"},
                                                  {1.25e-7, "1.25e-7"},
                                                  {1e16, "10000000000000000"},
                                                  {1.5e17, "1.5e17"},
                                                  {123456.789, "123456.789"},
                                                  {5e-324, "5e-324"},
                                                  {1e300, "1e300"},
                                                  {kInf, "inf"},
                                                  {-kInf, "-inf"},
                                                  {std::nan(""), "nan"}};
  for (const auto& [x, text] : cases) EXPECT_EQ(numberText(x), text);
}

}  // namespace rigid_body_sim
