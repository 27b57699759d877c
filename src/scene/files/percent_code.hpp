#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rigid_body_sim {

/// Any bytes as printable ASCII without quotes and backslashes: others, and %, as % and two
/// hexadecimal digits. YAML holds no text that is not UTF-8, and slots may.
std::string percentEncoded(const std::string& bytes);

/// The inverse; none where a % is not followed by two hexadecimal digits.
std::optional<std::string> percentDecoded(std::string_view text);

}  // namespace rigid_body_sim
