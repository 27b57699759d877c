#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "scene/study/draws.hpp"

namespace rigid_body_sim {
namespace {

constexpr std::int64_t kDraws = 100000;

Study studyOf(const std::string& vary, bool latin = false) {
  return parseStudy("runs: 100000\nseed: 11\nlatin_hypercube: " +
                        std::string(latin ? "true" : "false") + "\nvary:\n" + vary,
                    "study.yaml");
}

std::vector<std::vector<double>> drawn(const Study& study, std::size_t path = 0) {
  const SceneValue own = SceneValue::of({0, 0, 0, 1});
  const Draws draws(study);
  std::vector<std::vector<double>> all(4);
  for (std::int64_t run = 0; run < kDraws; ++run) {
    const SceneValue value = draws.value(path, run, own);
    for (std::size_t i = 0; i < value.words.size(); ++i)
      all[i].push_back(std::stod(value.words[i].text));
  }
  return all;
}

/// √n times the greatest distance of the draws' distribution from another, in units of which
/// chance exceeds 1.95 once in a thousand times (Kolmogorov).
template <class Cumulative>
double kolmogorov(std::vector<double> x, const Cumulative& cumulative) {
  std::sort(x.begin(), x.end());
  const auto n = static_cast<double>(x.size());
  double greatest = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double p = cumulative(x[i]);
    greatest =
        std::max({greatest, p - static_cast<double>(i) / n, static_cast<double>(i + 1) / n - p});
  }
  return std::sqrt(n) * greatest;
}

double normalCumulative(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

double meanOf(const std::vector<double>& x) {
  double sum = 0;
  for (const double each : x) sum += each;
  return sum / static_cast<double>(x.size());
}

double deviationOf(const std::vector<double>& x) {
  const double mean = meanOf(x);
  double sum = 0;
  for (const double each : x) sum += (each - mean) * (each - mean);
  return std::sqrt(sum / static_cast<double>(x.size()));
}

}  // namespace

TEST(Draws, FollowTheNormalDistribution) {
  const auto x = drawn(studyOf("  a: {normal: {mean: 3, stddev: 0.5}}"))[0];
  const double sigma = 0.5 / std::sqrt(static_cast<double>(kDraws));
  EXPECT_NEAR(meanOf(x), 3, 3.5 * sigma);
  EXPECT_NEAR(deviationOf(x), 0.5, 3.5 * sigma / std::sqrt(2.0));
  EXPECT_LT(kolmogorov(x, [](double v) { return normalCumulative((v - 3) / 0.5); }), 1.95);
}

TEST(Draws, FollowTheUniformDistribution) {
  const auto x = drawn(studyOf("  a: {uniform: [-1, 4]}"))[0];
  const double sigma = 5 / std::sqrt(12.0 * static_cast<double>(kDraws));
  EXPECT_NEAR(meanOf(x), 1.5, 3.5 * sigma);
  EXPECT_LT(kolmogorov(x, [](double v) { return (v + 1) / 5; }), 1.95);
  EXPECT_GE(*std::min_element(x.begin(), x.end()), -1);
  EXPECT_LT(*std::max_element(x.begin(), x.end()), 4);
}

TEST(Draws, TakeEachValueOfAListEquallyOften) {
  const auto x = drawn(studyOf("  a: {list: [1, 2, 5]}"))[0];
  for (const double value : {1.0, 2.0, 5.0}) {
    const double count = static_cast<double>(std::count(x.begin(), x.end(), value));
    EXPECT_NEAR(count, kDraws / 3.0, 3.5 * std::sqrt(kDraws * 2 / 9.0)) << value;
  }
}

TEST(Draws, HitEveryStratumOfALatinHypercubeOnce) {
  const Study study =
      studyOf("  a: {uniform: [0, 100000]}\n  b: {normal: {mean: 0, stddev: 1}}", true);
  std::vector<double> x = drawn(study)[0], y = drawn(study, 1)[0];
  double product = 0;
  for (std::size_t i = 0; i < x.size(); ++i) product += (x[i] - 5e4) / 5e4 * y[i];
  // the strata of one path are in no order with those of another
  EXPECT_LT(std::abs(product), 3.5 * std::sqrt(kDraws / 3.0));
  std::sort(x.begin(), x.end());
  std::sort(y.begin(), y.end());
  for (std::size_t i = 0; i < x.size(); ++i) {
    ASSERT_EQ(std::floor(x[i]), static_cast<double>(i));
    ASSERT_EQ(std::floor(kDraws * normalCumulative(y[i]) + 1e-6 * (y[i] > 0 ? -1 : 1)),
              static_cast<double>(i));
  }
}

TEST(Draws, TurnToEveryAttitudeAlike) {
  const auto q = drawn(studyOf("  a.orientation: {rotation: {}}"));
  std::vector<double> height, angle;
  for (std::size_t i = 0; i < q[0].size(); ++i) {
    const double x = q[0][i], y = q[1][i], z = q[2][i], w = q[3][i];
    ASSERT_NEAR(x * x + y * y + z * z + w * w, 1, 1e-14);
    height.push_back(1 - 2 * (x * x + y * y));  // of the turned z axis: uniform, as on a sphere
    angle.push_back(2 * std::acos(std::min(1.0, std::abs(w))));
  }
  EXPECT_LT(kolmogorov(height, [](double h) { return 0.5 * (h + 1); }), 1.95);
  // Haar measure: density (1 − cos θ)/π
  EXPECT_LT(kolmogorov(angle, [](double a) { return (a - std::sin(a)) / M_PI; }), 1.95);
}

TEST(Draws, TurnByNormalRotationVectors) {
  const auto q = drawn(studyOf("  a.orientation: {rotation: {stddev: 0.1}}"));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    std::vector<double> turn;
    for (std::size_t i = 0; i < q[0].size(); ++i) {
      const double s = std::sqrt(1 - q[3][i] * q[3][i]), a = 2 * std::atan2(s, q[3][i]);
      turn.push_back(s > 0 ? a * q[axis][i] / s : 0);
    }
    EXPECT_LT(kolmogorov(turn, [](double v) { return normalCumulative(v / 0.1); }), 1.95) << axis;
  }
}

TEST(Draws, TurnAboutTheAxesOfTheBody) {
  const Study study = studyOf("  a.orientation: {rotation: {stddev: 0.3}}");
  const Draws draws(study);
  const auto drawnFrom = [&draws](const Eigen::Quaterniond& own) {
    const SceneValue value =
        draws.value(0, 5, SceneValue::of({own.x(), own.y(), own.z(), own.w()}));
    const auto number = [&value](std::size_t i) { return std::stod(value.words.at(i).text); };
    return Eigen::Quaterniond(number(3), number(0), number(1), number(2));
  };
  const Eigen::Quaterniond unit = Eigen::Quaterniond(0.5, -0.1, 0.7, 0.3).normalized();
  const Eigen::Quaterniond turn = drawnFrom(Eigen::Quaterniond::Identity());
  EXPECT_GT(turn.vec().norm(), 0.05);
  EXPECT_LT(drawnFrom(unit).angularDistance(unit * turn), 1e-7);  // √ε: it is an arc cosine
  EXPECT_GT(drawnFrom(unit).angularDistance(turn * unit), 0.05);
}

TEST(Draws, GiveTheReferenceValuesOfTheGenerator) {
  // of the body drone and the imu imu with seed 1
  const Study study = parseStudy(
      "runs: 5\nseed: 1\nvary:\n  drone/imu: {normal: {mean: 0, stddev: 1}}", "study.yaml");
  const Draws draws(study);
  const double x[] = {-0.52786128634408969, 0.057715361159485279, -0.7992342491302884,
                      -1.2372488560731687, 0.38765869181679036};
  for (std::int64_t run = 0; run < 5; ++run) EXPECT_NEAR(draws.normal(0, run, 0), x[run], 1e-14);
}

TEST(Draws, DependOnSeedRunAndPathAlone) {
  const Study one = studyOf("  a: {normal: {mean: 0, stddev: 1}}");
  const Study other =
      studyOf("  b: {uniform: [0, 1]}\n  a: {normal: {mean: 0, stddev: 1}}\n  c: {grid: [1, 2]}");
  EXPECT_EQ(Draws(one).normal(0, 77, 0), Draws(other).normal(1, 77, 0));
  EXPECT_NE(Draws(other).uniform(0, 77, 0), Draws(other).uniform(1, 77, 0));
  EXPECT_NE(Draws(one).normal(0, 77, 0), Draws(one).normal(0, 78, 0));
}

TEST(Draws, CombineGridsEachWithEach) {
  const Study study =
      parseStudy("runs: 2\nvary:\n  a: {grid: [1, 2, 3, 4]}\n  b: {grid: [10, 20]}", "s");
  const Draws draws(study);
  ASSERT_EQ(draws.runs(), 16);
  std::multiset<std::string> pairs;
  for (std::int64_t run = 0; run < draws.runs(); ++run)
    pairs.insert(draws.value(0, run, {}).words[0].text + " " +
                 draws.value(1, run, {}).words[0].text);
  for (const char* pair : {"1 10", "1 20", "2 10", "2 20", "3 10", "3 20", "4 10", "4 20"})
    EXPECT_EQ(pairs.count(pair), 2U) << pair;
}

TEST(Permuted, PutsEveryPlaceElsewhereOnce) {
  for (const std::uint64_t size : {1U, 2U, 7U, 1000U}) {
    std::set<std::uint64_t> places;
    for (std::uint64_t i = 0; i < size; ++i) places.insert(permuted(5, i, size));
    EXPECT_EQ(places.size(), size);
    EXPECT_EQ(*places.rbegin(), size - 1);
  }
}

}  // namespace rigid_body_sim
