#pragma once

#include <string>

#include "scene/readers/yaml_tree.hpp"

namespace rigid_body_sim {

/// 16 hexadecimal digits that differ where the keys, values or structure of two documents do, as
/// good as certainly; comments, quotes and layout do not count. FNV-1a, 64 bits.
std::string fingerprintOf(const YamlNode& root);

}  // namespace rigid_body_sim
