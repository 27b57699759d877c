#include <algorithm>
#include <limits>

#include <rigid_body_sim/dynamics/force_law.hpp>

namespace rigid_body_sim {

void ForceLaw::setStart(double* own) const { std::fill_n(own, stateCount(), 0.0); }

void ForceLaw::setRates(const Bodies& /*at*/, double* rates) const {
  std::fill_n(rates, stateCount(), 0.0);
}

double ForceLaw::longestStep(const Bodies& /*at*/, double /*precision*/) const {
  return std::numeric_limits<double>::infinity();
}

double ForceLaw::distanceToKink(const Bodies& /*at*/, const std::vector<BodyMotion>& /*motions*/,
                                double /*h*/, double /*negligible*/) const {
  return std::numeric_limits<double>::infinity();
}

double ForceLaw::touchRadius(std::size_t /*k*/) const {
  return std::numeric_limits<double>::infinity();
}

}  // namespace rigid_body_sim
