#include "sections.hpp"

namespace rigid_body_sim::extremes {

std::vector<NamedSection> oneBodySections() {
  return {{"needle", needles},
          {"plate", plates},
          {"sphere", nearSpheres},
          {"two_equal", nearlySymmetric},
          {"spin", [](const Names& rows) { return spins(rows); }},
          {"step", steps},
          {"turn", [](const Names& rows) { return turns(rows); }},
          {"separatrix", separatrix},
          {"position", positions},
          {"mass", masses},
          {"force", centralForces},
          {"lever", [](const Names& rows) { return offCentreForces(rows); }},
          {"conflict", conflicts},
          {"arm", arms},
          {"far_pull", farPulls},
          {"through_zero", throughZero}};
}

}  // namespace rigid_body_sim::extremes
