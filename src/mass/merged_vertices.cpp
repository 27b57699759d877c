#include "mass/merged_vertices.hpp"

#include <cstring>
#include <limits>

namespace rigid_body_sim {
namespace {

/// Hash of a position by its bits; multiply and fold of splitmix64 (Steele, Lea & Flood 2014).
std::uint64_t hashOf(const Vector3d& position) {
  std::uint64_t hash = 0;
  for (int i = 0; i < 3; ++i) {
    const double coordinate = position[i] + 0.0;  // −0 becomes 0
    std::uint64_t bits;
    std::memcpy(&bits, &coordinate, sizeof bits);
    hash = (hash ^ bits) + 0x9e3779b97f4a7c15u;
    hash = (hash ^ (hash >> 30)) * 0xbf58476d1ce4e5b9u;
    hash = (hash ^ (hash >> 27)) * 0x94d049bb133111ebu;
    hash ^= hash >> 31;
  }
  return hash;
}

/// Set of positions by open addressing: 8 bytes or more a vertex in one block, where a node-based
/// map would allocate ten times as much in as many pieces.
class PositionIndex {
 public:
  explicit PositionIndex(std::size_t most_positions) {
    std::size_t slots = 16;
    while (slots < 2 * most_positions) slots *= 2;
    slots_.assign(slots, kEmpty);
  }

  /// Index of the position among those stored; it is appended if it is new.
  std::uint32_t indexOf(const Vector3d& position, std::vector<Vector3d>& stored) {
    std::size_t slot = hashOf(position) & (slots_.size() - 1);
    while (slots_[slot] != kEmpty && stored[slots_[slot]] != position)
      slot = (slot + 1) & (slots_.size() - 1);
    if (slots_[slot] == kEmpty) {
      slots_[slot] = static_cast<std::uint32_t>(stored.size());
      stored.push_back(position);
    }
    return slots_[slot];
  }

 private:
  static constexpr std::uint32_t kEmpty = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> slots_;
};

}  // namespace

TriangleMesh withMergedVertices(const TriangleMesh& mesh) {
  TriangleMesh merged;
  PositionIndex index(mesh.vertices.size());
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> merged_from(mesh.vertices.size(), kUnused);
  merged.triangles.reserve(mesh.triangles.size());
  for (Triangle t : mesh.triangles) {
    for (std::uint32_t& corner : t) {
      std::uint32_t& known = merged_from[corner];
      if (known == kUnused) known = index.indexOf(mesh.vertices[corner], merged.vertices);
      corner = known;
    }
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) merged.triangles.push_back(t);
  }
  return merged;
}

}  // namespace rigid_body_sim
