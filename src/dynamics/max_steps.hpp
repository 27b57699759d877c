#pragma once

namespace rigid_body_sim {

/// 2⁵³: the steps of a run are counted in doubles, too, which do not count by ones from there on.
constexpr double kMaxSteps = 9007199254740992;

}  // namespace rigid_body_sim
