#pragma once

#include <algorithm>
#include <vector>

namespace rigid_body_sim {

/// The kernels but for those of more lanes than RIGID_BODY_SIM_MOST_LANES, by which
/// scripts/test_widths runs the tests at each width; all where it is not defined.
template <class Kernels>
std::vector<Kernels> upToMostLanes(std::vector<Kernels> kernels) {
#if defined(RIGID_BODY_SIM_MOST_LANES)
  kernels.erase(
      std::remove_if(kernels.begin(), kernels.end(),
                     [](const Kernels& each) { return each.lanes > RIGID_BODY_SIM_MOST_LANES; }),
      kernels.end());
#endif
  return kernels;
}

}  // namespace rigid_body_sim
