#include <rigid_body_sim/dynamics/spring.hpp>

#include "dynamics/laws/law_rules.hpp"
#include "dynamics/laws/line.hpp"

namespace rigid_body_sim {
namespace {

double tensionOf(const Spring::Constants& constants, const Line& line) {
  return constants.stiffness * (line.length - constants.rest_length) +
         constants.damping * line.rate;
}

}  // namespace

Spring::Spring(const End& from, const End& to, const Constants& constants)
    : ends_{from, to}, constants_(constants) {
  checkEnds("spring", ends_);
  requireNotNegative("spring", "stiffness must be >= 0 N/m", constants.stiffness);
  requireNotNegative("spring", "damping must be >= 0 N s/m", constants.damping);
  requireNotNegative("spring", "rest_length must be >= 0 m", constants.rest_length);
}

std::vector<std::size_t> Spring::members() const { return membersOf(ends_); }

std::shared_ptr<const ForceLaw> Spring::reindexed(
    const std::function<std::size_t(std::size_t)>& index) const {
  auto copy = std::make_shared<Spring>(*this);
  copy->ends_ = reindexedEnds(ends_, index);
  return copy;
}

std::shared_ptr<const ForceLaw> Spring::reframed(std::size_t body, const Body& before,
                                                 const Body& after) const {
  auto copy = std::make_shared<Spring>(*this);
  copy->ends_ = reframedEnds(ends_, body, frameBefore(before, after));
  return copy;
}

void Spring::addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const {
  const Line line = lineBetween(ends_, at, constants_.damping > 0);
  addTension(ends_, line, tensionOf(constants_, line), at, wrenches);
}

double Spring::tension(const Bodies& at) const {
  const Line line = lineBetween(ends_, at, constants_.damping > 0);
  return line.length > 0 ? tensionOf(constants_, line) : 0;
}

double Spring::potentialEnergy(const Bodies& at) const {
  const double extension = gapBetween(ends_, at).norm() - constants_.rest_length;
  return 0.5 * constants_.stiffness * extension * extension;
}

double Spring::reach(const Bodies& at) const { return reachOf(ends_, at); }

double Spring::externalPower(const Bodies& at) const {
  if (!(constants_.damping > 0)) return 0;
  const Line line = lineBetween(ends_, at, true);
  return -constants_.damping * line.rate * line.rate;
}

void Spring::addStiffness(const std::vector<const Body*>& bodies,
                          std::vector<Stiffness>& stiffness) const {
  addStiffnessOf(ends_, constants_.stiffness, constants_.damping, bodies, stiffness);
}

}  // namespace rigid_body_sim
