// What a triangle costs: integrals and checks of a sphere, from a thousand triangles to a million.
#include <benchmark/benchmark.h>

#include <rigid_body_sim/mass/checked_mesh.hpp>

#include "support/mesh_edits.hpp"
#include "support/triangulations.hpp"

namespace rigid_body_sim {
namespace {

/// n segments of a full turn make n² − 2 n triangles or so.
TriangleMesh sphere(const benchmark::State& state) {
  return triangulated(Sphere{1}, static_cast<std::uint32_t>(state.range(0)));
}

void reportPerTriangle(benchmark::State& state, const TriangleMesh& mesh) {
  const auto triangles = static_cast<double>(mesh.triangles.size());
  state.counters["triangles"] = triangles;
  state.counters["per_triangle"] = benchmark::Counter(
      triangles, benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void integrateMesh(benchmark::State& state) {
  const TriangleMesh mesh = sphere(state);
  for (auto _ : state) benchmark::DoNotOptimize(massProperties(mesh, 1));
  reportPerTriangle(state, mesh);
}

void checkMeshOfFile(benchmark::State& state) {
  const TriangleMesh mesh = soup(sphere(state));
  for (auto _ : state) benchmark::DoNotOptimize(checkedMesh(mesh));
  reportPerTriangle(state, mesh);
}

BENCHMARK(integrateMesh)->Arg(32)->Arg(320)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK(checkMeshOfFile)->Arg(32)->Arg(320)->Arg(1024)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rigid_body_sim

BENCHMARK_MAIN();
