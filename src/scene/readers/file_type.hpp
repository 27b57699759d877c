#pragma once

#include <string>

namespace rigid_body_sim {

/// Whether a file with that extension is of a type that is well known and not read here.
bool isOfUnsupportedType(const std::string& extension);

/// Throws SceneError for a path that is a mesh's, a URDF file's or one of an unsupported type by
/// its extension, with what to do instead. Any other name may be a scene's.
void requireSceneName(const std::string& path);

}  // namespace rigid_body_sim
