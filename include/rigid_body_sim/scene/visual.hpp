#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>

#include <rigid_body_sim/mass/shapes.hpp>

namespace rigid_body_sim {

using Color = std::array<double, 4>;  ///< red, green, blue, opacity, each 0 … 1

/// A mesh file that a viewer opens by itself.
struct MeshVisual {
  std::string url;                    ///< package:// or file://
  Vector3d scale = Vector3d::Ones();  ///< along the axes of the file
};

/// A square of the plane z = 0 of its own frame, around the origin.
struct PatchVisual {
  double side;  ///< [m]
};

/// One thing to draw, fixed to a body.
struct Visual {
  std::variant<Shape, MeshVisual, PatchVisual> geometry;
  Isometry3d X_BV = Isometry3d::Identity();  ///< the geometry's own frame in the body frame
  std::optional<Color> color;                ///< none: as the viewer likes
};

}  // namespace rigid_body_sim
