#pragma once

#include <vector>

#include "scene/readers/entry.hpp"
#include "scene/study/study.hpp"

namespace rigid_body_sim {

/// The value of `record`: what is recorded beside the end states.
std::vector<RecordDef> readRecords(const Entry& entry);

/// The quantities of a body, in the order of simulate's CSV, then the norms.
const std::vector<std::string>& quantityNames();

}  // namespace rigid_body_sim
