#include "mass/shell_nesting.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "mass/shell_crossing.hpp"

namespace rigid_body_sim {
namespace {

constexpr std::size_t kMaxWork = 50000000;      // solid angles or so: a second or two
constexpr std::size_t kMaxCrossings = 4000000;  // pairs of triangles

/// Where points of one shell lie to another; those on its surface, or nearly so, are neither.
struct Sides {
  bool inside = false, outside = false;
};

enum class Relation { kApart, kWithin, kAround, kOverlap };

class Comparison {
 public:
  Comparison(const TriangleMesh& mesh, const std::vector<Shell>& shells)
      : mesh_(mesh), shells_(shells) {
    nesting_.within.resize(shells.size());
  }

  ShellNesting compareAll() {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < shells_.size(); ++i)
      if (!shells_[i].is_flat) order.push_back(i);
    const auto left = [this](std::size_t i) { return shells_[i].box.min().x(); };
    std::sort(order.begin(), order.end(),
              [&](std::size_t i, std::size_t j) { return left(i) < left(j); });
    for (std::size_t at = 0; at < order.size(); ++at)
      for (std::size_t next = at + 1; next < order.size(); ++next) {
        if (left(order[next]) > shells_[order[at]].box.max().x()) break;
        if (!compare(std::min(order[at], order[next]), std::max(order[at], order[next]))) {
          nesting_.is_complete = false;
          return nesting_;
        }
      }
    return nesting_;
  }

 private:
  /// False when this would be too much work.
  bool compare(std::size_t i, std::size_t j) {
    ++work_;
    if (shells_[i].box.intersects(shells_[j].box)) {
      const Relation relation = relationOf(shells_[i], shells_[j]);
      const bool overlap = relation == Relation::kOverlap ||
                           (relation == Relation::kWithin && !putWithin(i, j)) ||
                           (relation == Relation::kAround && !putWithin(j, i));
      if (overlap && nesting_.overlaps++ == 0) nesting_.first_overlap = {i, j};
    }
    return work_ <= kMaxWork;
  }

  /// False where the outer one is not larger, as only surfaces that pass through each other make
  /// it.
  bool putWithin(std::size_t inner, std::size_t outer) {
    if (!(size(inner) < size(outer))) return false;
    std::optional<std::size_t>& known = nesting_.within[inner];
    if (!known || size(outer) < size(*known)) known = outer;
    return true;
  }

  double size(std::size_t i) const { return std::abs(shells_[i].volume); }

  Relation relationOf(const Shell& i, const Shell& j) {
    const Sides i_to_j = sides(i, j), j_to_i = sides(j, i);
    const bool split = (i_to_j.inside && i_to_j.outside) || (j_to_i.inside && j_to_i.outside);
    const bool each_in_other = i_to_j.inside && j_to_i.inside;
    const bool same_surface =
        !i_to_j.inside && !i_to_j.outside && !j_to_i.inside && !j_to_i.outside;
    if (split || each_in_other || same_surface || doCross(i, j)) return Relation::kOverlap;
    if (i_to_j.inside) return Relation::kWithin;
    return j_to_i.inside ? Relation::kAround : Relation::kApart;
  }

  Sides sides(const Shell& of, const Shell& to) {
    const std::size_t count =
        std::min(of.triangles.size(), std::clamp<std::size_t>(200000 / to.triangles.size(), 2, 32));
    Sides found;
    for (std::size_t k = 0; k < count; ++k) {
      const Triangle& t = mesh_.triangles[of.triangles[k * of.triangles.size() / count]];
      const Vector3d middle =
          (mesh_.vertices[t[0]] + mesh_.vertices[t[1]] + mesh_.vertices[t[2]]) / 3;
      double winding = 0;
      if (to.box.contains(middle)) {
        winding = std::abs(windingNumber(mesh_, to, middle));
        work_ += to.triangles.size();
      }
      found.inside |= winding > 0.75;
      found.outside |= winding < 0.25;
    }
    return found;
  }

  bool doCross(const Shell& i, const Shell& j) {
    const CommonTriangles common = commonTriangles(mesh_, i, j);
    work_ += i.triangles.size() + j.triangles.size();
    if (common.pairs() > kMaxCrossings) return false;
    work_ += common.pairs() / 8;
    const double size = std::min(i.box.diagonal().norm(), j.box.diagonal().norm());
    return cross(mesh_, common, 1e-6 * size);
  }

  const TriangleMesh& mesh_;
  const std::vector<Shell>& shells_;
  ShellNesting nesting_;
  std::size_t work_ = 0;
};

}  // namespace

double windingNumber(const TriangleMesh& mesh, const Shell& shell, const Vector3d& point) {
  double half_angles = 0;
  for (const std::uint32_t k : shell.triangles) {
    const Triangle& t = mesh.triangles[k];
    const Vector3d a = mesh.vertices[t[0]] - point;
    const Vector3d b = mesh.vertices[t[1]] - point;
    const Vector3d c = mesh.vertices[t[2]] - point;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    const double lengths = la * lb * lc;
    const double sine = a.dot(b.cross(c));
    const double cosine = lengths + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb;
    // on the triangle, or as good as: neither side of it
    if (cosine < 0 && std::abs(sine) <= 1e-6 * lengths) continue;
    half_angles += std::atan2(sine, cosine);
  }
  return half_angles / (2 * M_PI);
}

ShellNesting nestingOf(const TriangleMesh& mesh, const std::vector<Shell>& shells) {
  return Comparison(mesh, shells).compareAll();
}

}  // namespace rigid_body_sim
