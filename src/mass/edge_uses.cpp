#include "mass/edge_uses.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace rigid_body_sim {

EdgeUses::EdgeUses(const TriangleMesh& mesh)
    : first_(mesh.vertices.size() + 1, 0), uses_(3 * mesh.triangles.size()) {
  constexpr std::array<std::size_t, 3> kNext{1, 2, 0};
  for (const Triangle& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++first_[std::min(t[i], t[kNext[i]]) + std::size_t{1}];
  std::partial_sum(first_.begin(), first_.end(), first_.begin());

  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t k = 0; k < mesh.triangles.size(); ++k) {
    const Triangle& t = mesh.triangles[k];
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = t[i], to = t[kNext[i]];
      const std::uint64_t upper = std::max(from, to);
      uses_[next[std::min(from, to)]++] = upper << 33 | std::uint64_t{from > to} << 32 | k;
    }
  }
  for (std::size_t v = 0; v + 1 < first_.size(); ++v)
    std::sort(uses_.data() + first_[v], uses_.data() + first_[v + 1]);
}

}  // namespace rigid_body_sim
