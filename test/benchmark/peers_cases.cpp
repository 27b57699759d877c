#include "benchmark/peers_cases.hpp"

#include <cmath>

#include "benchmark/peers_ours.hpp"
#include "benchmark/peers_truth.hpp"

namespace rigid_body_sim::peers {
namespace {

constexpr Array3 kGravity{0, 0, -9.81};  // [m/s²]
constexpr double kBoxMass = 2;           // [kg] of 1 × 0.5 × 0.25 m
constexpr Array3 kBoxI{2. / 12 * (0.25 + 0.0625), 2. / 12 * (1 + 0.0625), 2. / 12 * 1.25};

Problem freeBody(const char* name, const Array3& w_P, double duration) {
  Problem p{name, 1, {1, 2, 3}, {}};
  p.start.w_P = w_P;
  p.duration = duration;
  p.truth = truthOf(p);
  return p;
}

Problem caseA() { return freeBody("A", {0.5, 2, 0.3}, 100); }

Problem caseB() { return freeBody("B", {1e-4, 5, 1e-4}, 60); }

Problem caseC() {
  Problem p{"C", kBoxMass, kBoxI, {}, kGravity, {1, 2, 12}, {0.3, -0.1, 0.05}, 10};
  p.truth = truthOf(p);
  return p;
}

Problem caseD() {
  Problem p{"D", kBoxMass, kBoxI, {}, kGravity};
  p.start.x_W = {0.3, 0, -1.2};
  p.start.v_W = {0, 0.5, 0};
  p.start.w_P = {0.5, -1, 0.8};
  p.spring = SpringToWorld{{}, {0.1, -0.05, 0.2}, 60, 0.8};
  p.duration = 10;
  p.truth = truthApart(p);
  return p;
}

/// A free body with three wheels, whose torques change at once, every π/6.5 s.
Problem turnedByWheels(const char* name, const Array3& I, const Array3& w_P, double torque) {
  Problem p{name, 10, I, {}};
  p.start.w_P = w_P;
  p.duration = 10;
  p.wheels = ReactionWheels{0.5, 0.01};
  constexpr double kWait = 0.48332194670611;  // [s] no multiple of a step
  for (int n = 0; n * kWait < p.duration; ++n)
    p.wheels->commands.push_back(
        {n * kWait,
         {torque * std::sin(1.7 * n), torque * std::cos(2.3 * n), torque * std::sin(3.1 * n + 1)}});
  p.truth = truthApart(p);
  return p;
}

Problem caseE() { return turnedByWheels("E", {0.4, 0.5, 0.6}, {0.3, -0.2, 0.1}, 0.2); }

Problem caseF() { return turnedByWheels("F", {1, 2, 2.5}, {0.5, 2, 0.3}, 0.5); }

}  // namespace

const std::vector<Case>& cases() {
  static const std::vector<Case> all{{"A", caseA}, {"B", caseB}, {"C", caseC},
                                     {"D", caseD}, {"E", caseE}, {"F", caseF}};
  return all;
}

}  // namespace rigid_body_sim::peers
