#include "tools/plot/bodies_to_draw.hpp"

#include <algorithm>

#include "math/wide.hpp"

namespace rigid_body_sim {
namespace {

constexpr std::size_t kMaxDrawnBodies = 8;  // that one picture can tell apart

bool moves(const Samples<13>& samples) {
  return std::any_of(samples.rows.begin(), samples.rows.end(),
                     [&](const auto& row) { return row != samples.rows[0]; });
}

}  // namespace

std::vector<std::string> bodiesOf(const RunData& run) {
  std::vector<std::string> names;
  if (run.motion.empty())
    for (const auto& each : run.loads.all()) names.push_back(each.body);
  else
    for (const auto& each : run.motion.all()) names.push_back(each.body);
  return names;
}

std::vector<std::string> movingBodies(const RunData& run) {
  std::vector<std::string> moving;
  for (const auto& each : run.motion.all())
    if (moves(each.samples)) moving.push_back(each.body);
  return moving;
}

std::vector<std::string> bodiesToDraw(const RunData& run) {
  std::vector<std::string> bodies = movingBodies(run);
  if (bodies.empty()) bodies = bodiesOf(run);
  if (bodies.size() > kMaxDrawnBodies) bodies.resize(kMaxDrawnBodies);
  return bodies;
}

std::string bodyThatTurnsTooFar(const RunData& run, const std::vector<std::string>& bodies) {
  for (const auto& [body, samples] : run.motion.all()) {
    if (std::find(bodies.begin(), bodies.end(), body) == bodies.end()) continue;
    for (std::size_t k = 1; k < samples.t.size(); ++k)
      if (vectorAt(10, samples.rows[k]).norm() * (samples.t[k] - samples.t[k - 1]) > kPi<double>)
        return body;
  }
  return "";
}

}  // namespace rigid_body_sim
