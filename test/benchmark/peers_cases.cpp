#include "benchmark/peers_cases.hpp"

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

}  // namespace

const std::vector<Case>& cases() {
  static const std::vector<Case> all{{"A", caseA}, {"B", caseB}, {"C", caseC}, {"D", caseD}};
  return all;
}

}  // namespace rigid_body_sim::peers
