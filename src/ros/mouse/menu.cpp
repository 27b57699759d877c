#include "ros/mouse/menu.hpp"

#include <utility>

namespace rigid_body_sim {
namespace {

constexpr double kFastest = 1024;

}  // namespace

std::vector<visualization_msgs::MenuEntry> menuEntries() {
  static const std::vector<std::pair<MenuChoice, const char*>> titles = {
      {MenuChoice::kPause, "Pause"},
      {MenuChoice::kResume, "Resume"},
      {MenuChoice::kOneStep, "One step"},
      {MenuChoice::kTenSteps, "Ten steps"},
      {MenuChoice::kSlower, "Slower"},
      {MenuChoice::kFaster, "Faster"},
      {MenuChoice::kReset, "Reset"},
      {MenuChoice::kClearWrenches, "Clear wrenches"},
      {MenuChoice::kFollow, "Follow with the camera"},
      {MenuChoice::kStopFollowing, "Stop following"}};
  std::vector<visualization_msgs::MenuEntry> entries;
  for (const auto& [choice, title] : titles) {
    visualization_msgs::MenuEntry entry;
    entry.id = static_cast<std::uint32_t>(choice);
    entry.title = title;
    entry.command_type = visualization_msgs::MenuEntry::FEEDBACK;
    entries.push_back(entry);
  }
  return entries;
}

double slowerFactor(double real_time_factor) {
  if (real_time_factor == 0) return 1;
  return real_time_factor > 1 / kFastest ? real_time_factor / 2 : real_time_factor;
}

double fasterFactor(double real_time_factor) {
  return real_time_factor < kFastest ? 2 * real_time_factor : 0;
}

}  // namespace rigid_body_sim
