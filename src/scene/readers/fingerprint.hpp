#pragma once

#include <string>

#include "scene/readers/yaml_tree.hpp"

namespace rigid_body_sim {

/// 16 hexadecimal digits that differ where the keys, values or structure of two scenes do, as good
/// as certainly; comments, quotes, layout and `threads`, which changes no bit, do not count.
/// FNV-1a, 64 bits.
std::string fingerprintOf(const YamlNode& root);

}  // namespace rigid_body_sim
