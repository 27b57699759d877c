#pragma once

#include <vector>

#include <rigid_body_sim/scene/scene.hpp>
#include <rigid_body_sim/scene/visual.hpp>

namespace rigid_body_sim {

/// What there is to draw of a body, in its own frame: the mesh of `visual`, if it names one, else
/// what the body is made of:
///   a shape or mesh; every one of its parts; a small sphere for each particle, its volume in
///   proportion to the mass; the <visual> elements of its URDF link (there may be none); for given
///   properties the shapes of `collision`, else the box that has them, its density uniform; a
///   square of 20 m of a plane.
/// The colour of `visual` is that of all of them.
std::vector<Visual> visualsOf(const BodyDef& body);

}  // namespace rigid_body_sim
