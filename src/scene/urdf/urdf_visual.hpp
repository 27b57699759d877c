#pragma once

#include <filesystem>
#include <optional>

#include <urdf_model/link.h>

#include <rigid_body_sim/scene/visual.hpp>

#include "scene/urdf/read_urdf.hpp"

namespace rigid_body_sim {

Isometry3d toIsometry(const urdf::Pose& pose);

/// A <visual> in the frame of its link; relative names of mesh files start from the directory.
/// None for one without geometry, or of a kind of geometry that is not known here.
std::optional<Visual> toVisual(const urdf::Visual& visual, const std::filesystem::path& directory);

UrdfCollision toCollision(const urdf::Collision& collision);

}  // namespace rigid_body_sim
