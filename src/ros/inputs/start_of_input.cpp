#include "ros/inputs/start_of_input.hpp"

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace rigid_body_sim {

double startOfInput(const char* field, const ros::Time& stamp, const TimeOrigin& origin, double now,
                    double farthest) {
  if (stamp.isZero()) return now;
  const double start = origin.simulationTime(stamp);
  if (start <= now + farthest) return std::max(start, now);
  std::ostringstream fault;
  fault << field << " must be at most " << farthest << " s ahead of simulation time, got " << stamp
        << ", which is " << start - now << " s ahead: of another clock?";
  throw std::invalid_argument(fault.str());
}

}  // namespace rigid_body_sim
