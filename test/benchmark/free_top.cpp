#include "dynamics/rotation/free_top.hpp"

#include <vector>

#include <benchmark/benchmark.h>

#include "support/body_families.hpp"

/// Cost of the exact free rotation, per kind of body: a fresh anchor with one evaluation, and each
/// further evaluation. The bodies differ from call to call, as in a simulation of many.
namespace rigid_body_sim {
namespace {

constexpr std::size_t kBodies = 256;

std::vector<SpinningBody> bodiesOf(InertiaKind kind) {
  Random random(1);
  std::vector<SpinningBody> bodies(kBodies);
  for (SpinningBody& body : bodies) {
    body = randomSpinningBody(BodyFamily::generic, random);
    if (kind != InertiaKind::asymmetric) body.I(1) = body.I(0);
    if (kind == InertiaKind::spherical) body.I(2) = body.I(0);
  }
  return bodies;
}

void anchorAndEvaluate(benchmark::State& state, InertiaKind kind) {
  const std::vector<SpinningBody> bodies = bodiesOf(kind);
  std::vector<FreeTop<double>> tops;
  std::vector<Vector3d> L_W;
  for (const SpinningBody& body : bodies) {
    tops.emplace_back(body.I);
    L_W.push_back(body.L_W());
  }
  std::size_t i = 0;
  for (auto _ : state) {
    i = (i + 1) % kBodies;
    benchmark::DoNotOptimize(tops[i].from(bodies[i].q_WP, bodies[i].L_P, L_W[i]).at(1.0));
  }
}

void evaluate(benchmark::State& state, InertiaKind kind) {
  std::vector<FreeRotation<double>> motions;
  for (const SpinningBody& body : bodiesOf(kind))
    motions.push_back(FreeTop<double>(body.I).from(body.q_WP, body.L_P, body.L_W()));
  std::size_t i = 0;
  double t = 0;
  for (auto _ : state) {
    i = (i + 1) % kBodies;
    benchmark::DoNotOptimize(motions[i].at(t += 1e-3));
  }
}

/// Case A of the comparison with engines: I = (1, 2, 3), ω₀ = (0.5, 2, 0.3) rad/s, 100 s at once.
void caseA(benchmark::State& state) {
  const Vector3d I(1, 2, 3);
  const Vector3d L_P = I.cwiseProduct(Vector3d(0.5, 2, 0.3));
  for (auto _ : state)
    benchmark::DoNotOptimize(FreeTop<double>(I).from(Quaterniond::Identity(), L_P, L_P).at(100.0));
}

BENCHMARK_CAPTURE(anchorAndEvaluate, spherical, InertiaKind::spherical);
BENCHMARK_CAPTURE(anchorAndEvaluate, symmetric, InertiaKind::symmetric);
BENCHMARK_CAPTURE(anchorAndEvaluate, asymmetric, InertiaKind::asymmetric);
BENCHMARK_CAPTURE(evaluate, spherical, InertiaKind::spherical);
BENCHMARK_CAPTURE(evaluate, symmetric, InertiaKind::symmetric);
BENCHMARK_CAPTURE(evaluate, asymmetric, InertiaKind::asymmetric);
BENCHMARK(caseA);

}  // namespace
}  // namespace rigid_body_sim

BENCHMARK_MAIN();
