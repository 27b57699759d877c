#include "mass/shells.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace rigid_body_sim {
namespace {

/// Disjoint sets of triangles; the first triangle of a set names it.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }

  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  void unite(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Unites all triangles at an edge of more than two, unless each set is balanced there by itself.
void uniteUnbalanced(const Edge& edge, Sets& sets) {
  std::vector<std::pair<std::uint32_t, int>> uses;  // set, direction
  for (const EdgeUse* use = edge.begin; use != edge.end; ++use)
    uses.emplace_back(sets.find(triangleOf(*use)), runsDownwards(*use) ? -1 : 1);
  std::sort(uses.begin(), uses.end());
  int sum = 0;
  bool balanced = true;
  for (std::size_t i = 0; i < uses.size(); ++i) {
    if (i > 0 && uses[i].first != uses[i - 1].first) balanced = balanced && sum == 0;
    sum += uses[i].second;
  }
  if (balanced) return;
  for (const auto& [set, direction] : uses) sets.unite(set, uses.front().first);
}

Sets connected(const TriangleMesh& mesh, const EdgeUses& edges) {
  Sets sets(mesh.triangles.size());
  bool shared = false;
  edges.forEach([&](const Edge& edge) {
    if (edge.triangles() == 2)
      sets.unite(triangleOf(edge.begin[0]), triangleOf(edge.begin[1]));
    else
      shared = true;
  });
  if (shared)
    edges.forEach([&sets](const Edge& edge) {
      if (edge.triangles() > 2) uniteUnbalanced(edge, sets);
    });
  return sets;
}

void measure(const TriangleMesh& mesh, Shell& shell) {
  for (const std::uint32_t k : shell.triangles)
    for (const std::uint32_t corner : mesh.triangles[k]) shell.box.extend(mesh.vertices[corner]);
  const Vector3d middle = shell.box.center();
  double shell_area = 0, six_volumes = 0;
  for (const std::uint32_t k : shell.triangles) {
    const Triangle& t = mesh.triangles[k];
    const Vector3d a = mesh.vertices[t[0]] - middle;
    six_volumes += a.dot((mesh.vertices[t[1]] - mesh.vertices[t[0]])
                             .cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]));
    shell_area += area(mesh, t);
  }
  shell.volume = six_volumes / 6;
  shell.is_flat = isFlat(shell.volume, shell_area, shell.box.diagonal().norm());
}

}  // namespace

double area(const TriangleMesh& mesh, const Triangle& t) {
  const Vector3d& a = mesh.vertices[t[0]];
  const Vector3d along = mesh.vertices[t[1]] - a;
  return along.cross(mesh.vertices[t[2]] - a).norm() / 2;
}

bool isFlat(double volume, double area, double diameter) {
  const double rounding = 4 * std::numeric_limits<double>::epsilon() * diameter * area;
  return !std::isfinite(volume) || std::abs(volume) <= rounding;
}

std::vector<Shell> shellsOf(const TriangleMesh& mesh, const EdgeUses& edges) {
  Sets sets = connected(mesh, edges);
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  std::uint32_t k = 0;
  while (k < count && sets.find(k) == 0) ++k;
  if (k == count) return {};

  std::vector<Shell> shells;
  std::vector<std::uint32_t> shell_of(count);
  for (k = 0; k < count; ++k) {
    const std::uint32_t set = sets.find(k);
    if (set == k) {
      shell_of[k] = static_cast<std::uint32_t>(shells.size());
      shells.emplace_back();
    }
    shells[shell_of[set]].triangles.push_back(k);
  }
  for (Shell& shell : shells) measure(mesh, shell);
  return shells;
}

}  // namespace rigid_body_sim
