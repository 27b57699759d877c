#include <clocale>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>
#include <locale>
#include <random>

#include <gtest/gtest.h>

#include "scene_texts.hpp"

namespace rigid_body_sim {
namespace {

/// As a key holds it that takes every number > 0.
double valueOf(const std::string& number) {
  return parseScene(
             "time_step: 1\nbodies: [{name: a, shape: {sphere: {radius: 1}}, mass: 1}]\n"
             "tolerance: " +
                 number + "\n",
             "s")
      .tolerance;
}

}  // namespace

TEST(SceneNumbers, OfSeventeenDigitsComeBackAsTheSameBits) {
  std::mt19937_64 rng(7);
  for (int i = 0; i < 2000; ++i) {
    const std::uint64_t bits = rng() & 0x7fffffffffffffff;  // any positive double, also subnormal
    double x;
    std::memcpy(&x, &bits, sizeof x);
    if (!std::isfinite(x) || x == 0) continue;
    char text[40];
    std::snprintf(text, sizeof text, "%.17g", x);
    ASSERT_EQ(valueOf(text), x) << text;
  }
}

TEST(SceneNumbers, AreTheNearestDouble) {
  EXPECT_EQ(valueOf("0.1"), 0.1);
  EXPECT_EQ(valueOf("+.5"), 0.5);
  EXPECT_EQ(valueOf("5."), 5);
  EXPECT_EQ(valueOf("007"), 7);
  EXPECT_EQ(valueOf("1E3"), 1000);
  EXPECT_EQ(valueOf("4.9406564584124654e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(valueOf("1.7976931348623157e308"), std::numeric_limits<double>::max());
  // a hair above the midpoint of 1 and its successor, seen in the 50th digit only
  EXPECT_EQ(valueOf("1.00000000000000011102230246251565404236316680908203126"),
            1 + std::numeric_limits<double>::epsilon());
  EXPECT_EQ(valueOf("1.00000000000000011102230246251565404236316680908203124"), 1);
}

/// Writes a decimal comma and groups of three, as many a desktop's locale does.
struct CommaNumbers : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(SceneNumbers, DoNotDependOnTheLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale(), new CommaNumbers));
  const double number = valueOf("1234.5");
  const std::string error = errorOf("time_step: 1,5\nbodies: []\n");
  std::locale::global(before);
  EXPECT_EQ(number, 1234.5);
  EXPECT_EQ(error, "s.yaml:1: time_step must be a number [s], got 1,5");
}

}  // namespace rigid_body_sim
