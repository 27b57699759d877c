#include "scene/meshes/convex_hull.hpp"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

extern "C" {
#include <libqhull_r/libqhull_r.h>
}

#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

/// The point farthest by a measure, and how far.
template <class Measure>
std::pair<Vector3d, double> farthest(const std::vector<Vector3d>& points, const Measure& measure) {
  std::pair<Vector3d, double> found{points.front(), 0};
  for (const Vector3d& p : points) {
    const double distance = measure(p);
    if (distance > found.second) found = {p, distance};
  }
  return found;
}

/// Where the points lie that span no volume, to within the thickness; empty where they span one.
std::string flatness(const std::vector<Vector3d>& points, double thickness) {
  const Vector3d& a = points.front();
  const auto [b, length] = farthest(points, [&](const Vector3d& p) { return (p - a).norm(); });
  if (!(length > thickness)) return "at one place";
  const Vector3d along = (b - a) / length;
  const auto [c, width] =
      farthest(points, [&](const Vector3d& p) { return along.cross(p - a).norm(); });
  if (!(width > thickness)) return "on one line";
  const Vector3d normal = along.cross(c - a) / width;
  const auto [d, height] =
      farthest(points, [&](const Vector3d& p) { return std::abs(normal.dot(p - a)); });
  return height > thickness ? "" : "in one plane";
}

/// One run of Qhull, with what it says kept from the console.
class Qhull {
 public:
  /// coordinates: x, y, z of each point; they must outlive this.
  explicit Qhull(std::vector<double>& coordinates) : messages_(open_memstream(&text_, &size_)) {
    if (!messages_) throw std::runtime_error("convex hull: out of memory");
    qh_zero(&state_, messages_);
    char command[] = "qhull Qt";  // every facet a triangle
    exit_code_ = qh_new_qhull(&state_, 3, static_cast<int>(coordinates.size() / 3),
                              coordinates.data(), False, command, nullptr, messages_);
  }
  ~Qhull() {
    qh_freeqhull(&state_, !qh_ALL);  // its long memory and itself: what is short goes below
    int long_blocks = 0;
    int long_bytes = 0;
    qh_memfreeshort(&state_, &long_blocks, &long_bytes);
    std::fclose(messages_);
    std::free(text_);
  }
  Qhull(const Qhull&) = delete;
  Qhull& operator=(const Qhull&) = delete;

  /// The facets, by the indices of the points; oriented alike, all outwards or all inwards.
  std::vector<Triangle> facets() {
    requireDone();
    std::vector<Triangle> triangles;
    for (facetT* facet = state_.facet_list; facet && facet->next; facet = facet->next) {
      Triangle t{};
      for (std::size_t i = 0; i < 3; ++i) {
        const auto* vertex = static_cast<const vertexT*>(facet->vertices->e[i].p);
        t[i] = static_cast<std::uint32_t>(qh_pointid(&state_, vertex->point));
      }
      if (facet->toporient) std::swap(t[1], t[2]);
      triangles.push_back(t);
    }
    return triangles;
  }

 private:
  void requireDone() {
    if (exit_code_ == qh_ERRnone) return;
    std::fflush(messages_);
    const std::string text(text_, size_);
    throw std::runtime_error("convex hull cannot be computed: " +
                             oneLine(text.substr(0, text.find('\n'))));
  }

  char* text_ = nullptr;
  std::size_t size_ = 0;
  std::FILE* messages_;
  qhT state_;
  int exit_code_ = qh_ERRnone;
};

/// The mesh of triangles of these points, with only the vertices that they use.
TriangleMesh compacted(const std::vector<Vector3d>& points, std::vector<Triangle> triangles) {
  constexpr std::uint32_t kUnused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> index(points.size(), kUnused);
  for (const Triangle& t : triangles)
    for (const std::uint32_t corner : t) index[corner] = 0;
  TriangleMesh mesh;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (index[i] == kUnused) continue;
    index[i] = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.push_back(points[i]);
  }
  for (Triangle& t : triangles)
    for (std::uint32_t& corner : t) corner = index[corner];
  mesh.triangles = std::move(triangles);
  return mesh;
}

}  // namespace

TriangleMesh convexHull(const std::vector<Vector3d>& points, double thickness) {
  Eigen::AlignedBox3d box;
  for (const Vector3d& p : points) box.extend(p);
  const double size = box.diagonal().norm();
  const double least = std::max(thickness, 1e-12 * size);
  const std::string flat = points.empty() ? "nowhere" : flatness(points, least);
  if (!flat.empty()) {
    std::ostringstream fault;
    fault << "convex hull must enclose a volume, but all vertices lie " << flat << ", to within "
          << least << " m";
    throw std::runtime_error(fault.str());
  }

  // about their middle and of size 1: neither far away nor small is then special
  std::vector<double> coordinates;
  coordinates.reserve(3 * points.size());
  for (const Vector3d& p : points) {
    const Vector3d x = (p - box.center()) / size;
    coordinates.insert(coordinates.end(), {x.x(), x.y(), x.z()});
  }
  TriangleMesh hull = compacted(points, Qhull(coordinates).facets());
  if (volume(hull) < 0)
    for (Triangle& t : hull.triangles) std::swap(t[1], t[2]);
  return hull;
}

}  // namespace rigid_body_sim
