#pragma once

#include <string>

namespace rigid_body_sim::test {

/// The first lines of a scene's body `box`, whose principal frame is turned and shifted against its
/// own.
inline const std::string kLopsidedBox = R"(  - name: box
    mass: 2.0
    inertia: {ixx: 1.0, iyy: 1.5, izz: 2.0, ixy: 0.1, ixz: -0.2, iyz: 0.05}
    center_of_mass: [0.3, -0.2, 0.1]
)";

}  // namespace rigid_body_sim::test
