#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>

#include <ros/time.h>

namespace rigid_body_sim {

/// Parts the runs in a bag, which resets of time and loads have ended: there stamps go back.
class RunStarts {
 public:
  /// Whether another run begins with this message, of inFileOrder: its stamp lies before that of
  /// the last message on its topic. The first messages of a run on its other topics go back as
  /// well, and begin none.
  bool isStart(const std::string& topic, const ros::Time& stamp);

  std::size_t runs() const { return runs_; }

 private:
  std::map<std::string, ros::Time> last_;
  std::set<std::string> of_this_run_;  // topics
  std::size_t runs_ = 1;
};

}  // namespace rigid_body_sim
