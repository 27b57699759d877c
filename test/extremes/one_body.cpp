#include "sections.hpp"

namespace rigid_body_sim::extremes {

std::vector<NamedSection> oneBodySections() {
  return {{"needle", needles},
          {"plate", plates},
          {"sphere", nearSpheres},
          {"two_equal", nearlySymmetric},
          {"spin", [](const Names& integrators) { return spins(integrators); }},
          {"step", steps},
          {"turn", [](const Names& integrators) { return turns(integrators); }},
          {"separatrix", separatrix},
          {"position", positions},
          {"mass", masses},
          {"force", centralForces},
          {"lever", [](const Names& integrators) { return offCentreForces(integrators); }},
          {"conflict", conflicts},
          {"arm", arms},
          {"far_pull", farPulls},
          {"through_zero", throughZero}};
}

}  // namespace rigid_body_sim::extremes
