#include "mass/oriented_shells.hpp"

#include <sstream>
#include <utility>

#include "mass/shell_nesting.hpp"
#include "math/shortest.hpp"

namespace rigid_body_sim {
namespace {

void turn(Triangle& t) { std::swap(t[1], t[2]); }

/// Turns the mesh as a whole where its volume is negative.
std::vector<std::string> orientWhole(TriangleMesh& mesh) {
  const double mesh_volume = volume(mesh);
  if (!(mesh_volume < 0)) return {};
  for (Triangle& t : mesh.triangles) turn(t);
  std::ostringstream notice;
  notice << "mesh is oriented inwards (volume " << shortest(mesh_volume) << " m^3): its "
         << mesh.triangles.size() << " triangles are turned around";
  return {notice.str()};
}

std::string placeOf(const Shell& shell) {
  return "from " + shortest(shell.box.min()) + " to " + shortest(shell.box.max()) + " m";
}

/// The outermost shell around a shell, or itself. Each is larger than the one before: this ends.
std::size_t outermost(const ShellNesting& nesting, std::size_t i) {
  while (nesting.within[i]) i = *nesting.within[i];
  return i;
}

std::string turnedNotice(std::size_t turned, const std::vector<Shell>& shells, const Shell& first,
                         std::size_t triangles) {
  std::ostringstream notice;
  notice << "mesh has " << turned << " of " << shells.size()
         << " shells oriented inwards, the first " << placeOf(first) << ": their " << triangles
         << " triangles are turned around";
  return notice.str();
}

std::vector<std::string> doubleVolumeNotices(const std::vector<Shell>& shells,
                                             const ShellNesting& nesting) {
  std::vector<std::string> notices;
  std::size_t same_sense = 0, first = 0;
  for (std::size_t i = 0; i < shells.size(); ++i) {
    if (!nesting.within[i]) continue;
    const bool same = (shells[i].volume > 0) == (shells[*nesting.within[i]].volume > 0);
    if (same && same_sense++ == 0) first = i;
  }
  if (same_sense > 0)
    notices.push_back("shells within another that is oriented the same way: " +
                      std::to_string(same_sense) + ", the first " + placeOf(shells[first]) +
                      ": their volume counts twice; to make them cavities, turn them inside out");
  if (nesting.overlaps > 0)
    notices.push_back("pairs of shells that overlap: " + std::to_string(nesting.overlaps) +
                      ", the first " + placeOf(shells[nesting.first_overlap.first]) + " and " +
                      placeOf(shells[nesting.first_overlap.second]) +
                      ": the volume that they share counts twice");
  return notices;
}

}  // namespace

std::vector<std::string> orientShells(TriangleMesh& mesh, const EdgeUses& edges) {
  const std::vector<Shell> shells = shellsOf(mesh, edges);
  if (shells.empty()) return orientWhole(mesh);
  const ShellNesting nesting = nestingOf(mesh, shells);
  if (!nesting.is_complete) {
    std::vector<std::string> notices = orientWhole(mesh);
    notices.push_back("mesh has " + std::to_string(shells.size()) +
                      " shells, too many to compare: those that overlap or are inside out are not "
                      "found, and count twice or negatively");
    return notices;
  }

  std::vector<std::size_t> turned;
  std::size_t triangles = 0;
  for (std::size_t i = 0; i < shells.size(); ++i) {
    if (!(shells[outermost(nesting, i)].volume < 0) || shells[i].is_flat) continue;
    turned.push_back(i);
    triangles += shells[i].triangles.size();
  }
  std::vector<std::string> notices;
  if (triangles == mesh.triangles.size()) {
    notices = orientWhole(mesh);
  } else if (!turned.empty()) {
    for (const std::size_t i : turned)
      for (const std::uint32_t k : shells[i].triangles) turn(mesh.triangles[k]);
    notices.push_back(turnedNotice(turned.size(), shells, shells[turned.front()], triangles));
  }
  for (std::string& notice : doubleVolumeNotices(shells, nesting))
    notices.push_back(std::move(notice));
  return notices;
}

}  // namespace rigid_body_sim
