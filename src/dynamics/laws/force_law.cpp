#include <algorithm>

#include <rigid_body_sim/dynamics/force_law.hpp>

namespace rigid_body_sim {

void ForceLaw::setStart(double* own) const { std::fill_n(own, stateCount(), 0.0); }

void ForceLaw::setRates(const Bodies& /*at*/, double* rates) const {
  std::fill_n(rates, stateCount(), 0.0);
}

}  // namespace rigid_body_sim
