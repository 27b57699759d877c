#pragma once

#include <string>
#include <vector>

namespace rigid_body_sim {

/// Names as doc/node.md has them: <body>/NAME once for all bodies, ~NAME for those in the node's
/// own namespace; sorted. node: its full name; bodies: theirs, as topics resolve them.
std::vector<std::string> shortNames(const std::vector<std::string>& names, const std::string& node,
                                    const std::vector<std::string>& bodies);

/// What a node subscribes to, publishes and serves, in three lines for its log.
std::vector<std::string> interfaceLines(const std::vector<std::string>& bodies);

}  // namespace rigid_body_sim
