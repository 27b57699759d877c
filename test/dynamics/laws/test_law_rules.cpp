#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/buoyancy.hpp>
#include <rigid_body_sim/dynamics/central_gravity.hpp>
#include <rigid_body_sim/dynamics/drag.hpp>
#include <rigid_body_sim/dynamics/medium_drag.hpp>
#include <rigid_body_sim/dynamics/tether.hpp>

#include "support/refusal.hpp"

/// A law whose constants break a rule cannot be made.
namespace rigid_body_sim {
namespace {

const Spring::End kInWorld{kWorld, {0, 0, 1}}, kOnBody{0, {0, 0, 0}};

/// What is no finite number.
const std::vector<double> kNoNumbers{std::numeric_limits<double>::quiet_NaN(),
                                     std::numeric_limits<double>::infinity()};

TEST(LawRules, OfASpring) {
  const auto refusal = [](const Spring::Constants& constants) {
    return test::refusalOf([&] { Spring(kInWorld, kOnBody, constants); });
  };
  EXPECT_EQ(refusal({0, 0, 0}), "");
  EXPECT_EQ(refusal({-1, 0, 0}), "law 'spring': stiffness must be >= 0 N/m and finite, got -1");
  EXPECT_EQ(refusal({1, -2, 0}), "law 'spring': damping must be >= 0 N s/m and finite, got -2");
  EXPECT_EQ(refusal({1, 0, -0.5}), "law 'spring': rest_length must be >= 0 m and finite, got -0.5");
  for (double x : kNoNumbers) {
    EXPECT_NE(refusal({x, 0, 0}), "");
    EXPECT_NE(refusal({1, x, 0}), "");
    EXPECT_NE(refusal({1, 0, x}), "");
  }
}

TEST(LawRules, OfATether) {
  const auto refusal = [](const Tether::Constants& constants) {
    return test::refusalOf([&] { Tether(kInWorld, kOnBody, constants); });
  };
  EXPECT_EQ(refusal({1, 0, 1}), "");
  EXPECT_EQ(refusal({0, 0, 1}), "law 'tether': stiffness must be > 0 N/m and finite, got 0");
  EXPECT_EQ(refusal({1, -1, 1}), "law 'tether': damping must be >= 0 N s/m and finite, got -1");
  EXPECT_EQ(refusal({1, 0, 0}), "law 'tether': length must be > 0 m and finite, got 0");
  for (double x : kNoNumbers) {
    EXPECT_NE(refusal({x, 0, 1}), "");
    EXPECT_NE(refusal({1, x, 1}), "");
    EXPECT_NE(refusal({1, 0, x}), "");
  }
}

TEST(LawRules, OfTheEndsOfALine) {
  const auto refusal = [](const Spring::End& from, const Spring::End& to) {
    const std::string of_tether = test::refusalOf([&] { Tether(from, to, {1, 0, 1}); });
    EXPECT_EQ(of_tether.empty(), test::refusalOf([&] { Spring(from, to, {1, 0, 1}); }).empty());
    return of_tether;
  };
  EXPECT_EQ(refusal(kOnBody, {1, {0, 0, 0}}), "");
  for (const Spring::End& end : {kOnBody, kInWorld})
    EXPECT_EQ(refusal(end, {end.body, {1, 2, 3}}),
              "law 'tether': its ends must be on two bodies, or on one and in the world");
  EXPECT_EQ(refusal(kOnBody, {kWorld, {0, NAN, 0}}),
            "law 'tether': the points of its ends must be finite");
}

TEST(LawRules, OfDrag) {
  const auto refusal = [](const Drag::Coefficients& coefficients) {
    return test::refusalOf([&] { Drag(0, coefficients); });
  };
  EXPECT_EQ(refusal({1, 2, 3}), "");
  EXPECT_EQ(refusal({-1, 0, 0}), "law 'drag': linear must be >= 0 N s/m and finite, got -1");
  EXPECT_EQ(refusal({0, -1, 0}), "law 'drag': quadratic must be >= 0 N s^2/m^2 and finite, got -1");
  EXPECT_EQ(refusal({0, 0, -1}), "law 'drag': angular must be >= 0 N m s and finite, got -1");
  for (double x : kNoNumbers) EXPECT_NE(refusal({x, 0, 0}), "");
}

TEST(LawRules, OfDragInAMedium) {
  const auto refusal = [](const std::function<void(MediumDrag::Coefficients&, Vector3d&)>& change) {
    MediumDrag::Coefficients coefficients;
    coefficients.linear.axes = {1, 0, 2};
    Vector3d medium_W(1, 0, 0);
    change(coefficients, medium_W);
    return test::refusalOf([&] { MediumDrag(0, coefficients, medium_W); });
  };
  using Coefficients = MediumDrag::Coefficients;
  EXPECT_EQ(refusal([](Coefficients&, Vector3d&) {}), "");
  EXPECT_EQ(refusal([](Coefficients& c, Vector3d&) { c.quadratic.axes.y() = -1; }),
            "law 'drag': quadratic must be >= 0 N s^2/m^2 and finite, got -1");
  EXPECT_NE(refusal([](Coefficients& c, Vector3d&) { c.linear.alike = NAN; }), "");
  EXPECT_NE(refusal([](Coefficients& c, Vector3d&) { c.angular.axes.z() = NAN; }), "");
  EXPECT_EQ(refusal([](Coefficients& c, Vector3d&) { c.center_P.x() = NAN; }),
            "law 'drag': its center must be finite");
  EXPECT_EQ(refusal([](Coefficients&, Vector3d& medium_W) { medium_W.x() = NAN; }),
            "law 'drag': the velocity of the medium must be finite");
  EXPECT_EQ(refusal([](Coefficients& c, Vector3d&) { c.R_PD *= 2; }),
            "law 'drag': its axes must be unit and at right angles");
}

TEST(LawRules, OfCentralGravityAndBuoyancy) {
  EXPECT_EQ(test::refusalOf([] {
              CentralGravity(0, {0, 0, 0}, 0, false);
            }),
            "law 'central gravity': mu must be > 0 m^3/s^2 and finite, got 0");
  EXPECT_EQ(test::refusalOf([] {
              CentralGravity(0, {0, NAN, 0}, 1, false);
            }),
            "law 'central gravity': center must be finite");
  EXPECT_EQ(test::refusalOf([] {
              Buoyancy(0, -1, {0, 0, 0}, {0, 0, -9.8});
            }),
            "law 'buoyancy': the mass displaced must be >= 0 kg and finite, got -1");
  EXPECT_EQ(test::refusalOf([] {
              Buoyancy(0, 1, {0, 0, NAN}, {0, 0, -9.8});
            }),
            "law 'buoyancy': the centroid must be finite");
  EXPECT_EQ(test::refusalOf([] {
              Buoyancy(0, 1, {0, 0, 0}, {0, 0, NAN});
            }),
            "law 'buoyancy': gravity must be finite");
}

}  // namespace
}  // namespace rigid_body_sim
