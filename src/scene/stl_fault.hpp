#pragma once

#include <string>

namespace rigid_body_sim {

/// Says why the claim in the header of a binary STL file does not fit the file; empty for one that
/// does and for ascii STL. To be asked before a reader allocates what the header claims.
std::string stlFault(const std::string& path);

}  // namespace rigid_body_sim
