#pragma once

#include <string>
#include <vector>

#include <rigid_body_sim/math/types.hpp>

namespace rigid_body_sim {

/// Text from outside with every control character, line ends included, as ?.
std::string oneLine(std::string text);

/// Text from outside, fit for a message of one line: control characters become ?, and what is
/// longer than 60 bytes is cut.
std::string printable(const std::string& text);

/// "[1, 2, 3]"
std::string listed(const Vector3d& v);

/// Of how many names the nearest one is looked for: a message is no reason to wait.
constexpr std::size_t kMaxComparedNames = 10000;

/// "; did you mean 'box'?", with the name that differs least from the text where one differs
/// little; else empty.
std::string didYouMean(const std::string& text, const std::vector<std::string>& names);

/// The name that differs least from the text, however much; "" of none.
std::string nearestOf(const std::string& text, const std::vector<std::string>& names);

/// "a, b, c"; cut short after `most` of them.
std::string nameList(const std::vector<std::string>& names, std::size_t most = 10);

}  // namespace rigid_body_sim
