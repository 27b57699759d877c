#include "tools/simulate/recorded_run.hpp"

#include <algorithm>
#include <cmath>

#include "math/shortest.hpp"
#include "programs/formatted.hpp"
#include "ros/bag/record_end.hpp"

namespace rigid_body_sim {

RecordedRun::RecordedRun(const std::string& path, const Scene& scene, const World& world)
    : path_(path),
      recorded_(readBagInputs(path, scene, world)),
      end_(recordEnd(path, recorded_.origin)),
      replay_(recorded_.inputs) {}

std::string RecordedRun::notice() const {
  return recorded_.notice.empty() ? "" : path_ + ": " + recorded_.notice;
}

bool RecordedRun::showsItsEnd(double h) const {
  return end_ && *end_ >= std::max(begin(), static_cast<double>(replay_.lastStep()) * h);
}

std::string RecordedRun::lengthNotice(const Scene& scene) const {
  if (!recorded_.is_of_later_run || showsItsEnd(scene.time_step)) return "";
  return path_ + ": " +
         formatted(
             "holds several runs, separated by resets or loads, of which the last is repeated; "
             "its length is not known, it is taken to end at %s s: --duration says how long "
             "it was",
             shortest(end(scene)).c_str());
}

double RecordedRun::end(const Scene& scene) const {
  const double h = scene.time_step;
  if (!showsItsEnd(h)) return std::max(begin() + scene.horizon, endOfEffects(recorded_.inputs, h));
  return std::max(begin() / h + 1, std::floor(*end_ / h + 1e-6)) * h;
}

std::vector<InputEffects> RecordedRun::effects(const World& world) const {
  return effectsOf(recorded_.inputs, replay_.size() - replay_.remaining(), world.bodies.size());
}

std::string RecordedRun::remainder(double end) const {
  if (replay_.isDone()) return "";
  return formatted(
      "%s: %zu of %zu inputs were not applied: they come at or after %s s, where this "
      "run ends (--duration)",
      path_.c_str(), replay_.remaining(), replay_.size(), shortest(end).c_str());
}

}  // namespace rigid_body_sim
