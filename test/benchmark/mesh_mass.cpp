// What a triangle costs: reading, checking and integrating a sphere, from a thousand triangles to a
// million.
#include <filesystem>
#include <fstream>

#include <benchmark/benchmark.h>

#include <rigid_body_sim/mass/checked_mesh.hpp>

#include "scene/meshes/read_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/mesh_texts.hpp"
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

void readBinaryStl(benchmark::State& state) {
  const TriangleMesh mesh = sphere(state);
  const auto path = std::filesystem::temp_directory_path() / "rigid_body_sim_mesh_mass.stl";
  std::ofstream(path, std::ios::binary) << binaryStl(mesh);
  for (auto _ : state) benchmark::DoNotOptimize(readMesh(path.string()));
  std::filesystem::remove(path);
  reportPerTriangle(state, mesh);
}

BENCHMARK(readBinaryStl)->Arg(32)->Arg(320)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK(checkMeshOfFile)->Arg(32)->Arg(320)->Arg(1024)->Unit(benchmark::kMillisecond);
BENCHMARK(integrateMesh)->Arg(32)->Arg(320)->Arg(1024)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace rigid_body_sim

BENCHMARK_MAIN();
