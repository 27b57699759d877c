#pragma once

#include "scene/meshes/dae_document.hpp"

namespace rigid_body_sim {

/// The triangles of a geometry, in its own axes and unit.
struct DaeGeometry {
  TriangleMesh mesh;
  double rounding = 0;  ///< see NumberPrecision
};

/// Reads triangles, polylist, polygons, trifans and tristrips of a <geometry>; a polygon becomes
/// the fan about its first corner. Lines, and geometries without a <mesh>, have no part in a solid.
/// Throws as DaeDocument does.
DaeGeometry readDaeGeometry(const DaeDocument& document, const DaeElement& geometry);

}  // namespace rigid_body_sim
