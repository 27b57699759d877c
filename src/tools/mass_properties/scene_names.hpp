#pragma once

#include <string>
#include <vector>

namespace rigid_body_sim {

/// A name that a scene accepts, as near to the text as can be: what is no letter and no digit
/// becomes _, and the prefix is put before what does not begin with a letter or would be the world.
std::string sceneName(const std::string& text, const std::string& prefix);

/// The same for the links of a robot; no two alike.
std::vector<std::string> sceneNamesOfLinks(const std::vector<std::string>& links);

}  // namespace rigid_body_sim
