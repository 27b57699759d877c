#include "scene/build/displaced_volume.hpp"

#include "scene/build/body_mass.hpp"

namespace rigid_body_sim {
namespace {

/// The centre of mass of a homogeneous solid is the centroid of its volume.
DisplacedVolume volumeOfSolid(const SolidDef& solid) {
  return {volumeOf(solid.geometry), massProperties(solid).com_B};
}

std::optional<DisplacedVolume> volumeOfParts(const std::vector<PartDef>& parts) {
  DisplacedVolume sum;
  for (const PartDef& part : parts) {
    const auto* solid = std::get_if<SolidDef>(&part.content);
    if (!solid) return std::nullopt;
    const DisplacedVolume own = volumeOfSolid(*solid);
    sum.volume += own.volume;
    sum.center_B += own.volume * (part.position + rotate(part.orientation, own.center_B));
  }
  sum.center_B /= sum.volume;
  return sum;
}

}  // namespace

std::optional<DisplacedVolume> displacedVolume(const CompositionDef& composition) {
  if (const auto* solid = std::get_if<SolidDef>(&composition)) return volumeOfSolid(*solid);
  if (const auto* parts = std::get_if<std::vector<PartDef>>(&composition))
    return volumeOfParts(*parts);
  return std::nullopt;
}

}  // namespace rigid_body_sim
