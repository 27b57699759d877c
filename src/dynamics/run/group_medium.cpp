#include "dynamics/laws/medium_load.hpp"
#include "dynamics/run/group.hpp"

/// What a medium exerts on the body of a group that is solved.
namespace rigid_body_sim {

void Group::gatherMedium() {
  auto load = std::make_shared<MediumLoad>();
  const ForceLaw::Bodies at{system_.bodies, present_.bodies};
  for (const auto& law : system_.laws) law->addMedium(at, *load);
  for (const auto& law : system_.flows) law->addMedium(at, *load);
  forStatefulLaws(system_, present_, [&load](const ForceLaw& law, const ForceLaw::Bodies& own) {
    law.addMedium(own, *load);
  });
  if (!load->any()) return;
  system_.medium = std::move(load);
  system_.held[0].medium = system_.medium.get();
}

}  // namespace rigid_body_sim
