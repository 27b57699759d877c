#include <algorithm>
#include <cmath>
#include <sstream>

#include "benchmark/peers.hpp"

namespace rigid_body_sim::peers {

double errorOf(const Run& run, const Problem& problem) {
  // |q − p| and |q + p| are 2 sin and 2 cos of a quarter of the angle, at either sign of q
  double minus = 0, plus = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    minus += std::pow(run.q[i] - problem.truth[i], 2);
    plus += std::pow(run.q[i] + problem.truth[i], 2);
  }
  return 4 * std::atan(std::sqrt(std::min(minus, plus) / std::max(minus, plus)));
}

std::vector<Engine>& engines() {
  static std::vector<Engine> all;
  return all;
}

std::string label(const std::string& method, const char* what, double value) {
  std::ostringstream text;
  text << method << ", " << what << ' ' << value;
  return text.str();
}

}  // namespace rigid_body_sim::peers
