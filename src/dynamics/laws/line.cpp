#include "dynamics/laws/line.hpp"

#include "dynamics/laws/law_rules.hpp"
#include "dynamics/laws/mobility.hpp"

namespace rigid_body_sim {
namespace {

double mobility(const Spring::End& end, const std::vector<const Body*>& bodies) {
  return end.body == kWorld ? 0 : mobilityAt(*bodies[end.body], end.point);
}

}  // namespace

void checkEnds(const char* law, const LineEnds& ends) {
  require(ends[0].body != ends[1].body, "law '", law,
          "': its ends must be on two bodies, or on one and in the world");
  for (const Spring::End& end : ends) requireFinite(law, "the points of its ends", end.point);
}

std::vector<std::size_t> membersOf(const LineEnds& ends) {
  std::vector<std::size_t> bodies;
  for (const Spring::End& end : ends)
    if (end.body != kWorld) bodies.push_back(end.body);
  return bodies;
}

LineEnds reindexedEnds(LineEnds ends, const std::function<std::size_t(std::size_t)>& index) {
  for (Spring::End& end : ends)
    if (end.body != kWorld) end.body = index(end.body);
  return ends;
}

LineEnds reframedEnds(LineEnds ends, std::size_t body, const Isometry3d& X_NP) {
  for (Spring::End& end : ends)
    if (end.body == body) end.point = X_NP * end.point;
  return ends;
}

double reachOf(const LineEnds& ends, const ForceLaw::Bodies& at) {
  double reach = gapBetween(ends, at).norm();
  for (const Spring::End& end : ends)
    if (end.body != kWorld) reach += end.point.norm();
  return reach;
}

// The sums of absolute values along the rows of M^(−1/2) K M^(−1/2), which bound its eigenvalues
// (Gershgorin), M being the mass matrix and K the stiffness.
void addStiffnessOf(const LineEnds& ends, double stiffness, double damping,
                    const std::vector<const Body*>& bodies, std::vector<Stiffness>& sums) {
  const std::array<double, 2> a{mobility(ends[0], bodies), mobility(ends[1], bodies)};
  for (std::size_t k = 0; k < 2; ++k) {
    if (ends[k].body == kWorld) continue;
    const double row = a[k] + std::sqrt(a[0] * a[1]);
    sums[ends[k].body].frequency_squared += stiffness * row;
    sums[ends[k].body].decay += damping * row;
  }
}

}  // namespace rigid_body_sim
