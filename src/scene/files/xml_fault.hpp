#pragma once

#include <string>

namespace rigid_body_sim {

/// Says that the elements of a text of XML stand in one another deeper than kMaxXmlDepth, or that
/// its tags cannot be told; empty otherwise. To be asked before a parser that calls itself for each
/// level gets the text.
std::string xmlFault(const std::string& xml);

}  // namespace rigid_body_sim
