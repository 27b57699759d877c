#pragma once

#include <functional>
#include <string>
#include <vector>

namespace rigid_body_sim {

/// What is to be drawn, and where.
struct PlotJob {
  std::vector<std::string> files;   ///< a bag, or CSV files of one run
  std::string out = ".";            ///< directory of the pictures, made if absent
  std::vector<std::string> bodies;  ///< to draw; empty: as bodiesToDraw
};

/// Draws the figures of a run. note: takes a line for the user. Returns the files written, as one
/// line. Throws std::runtime_error with one line for files that cannot be read or written and
/// UsageError for a body that the run does not hold and for a picture that would overwrite a file
/// that is read.
std::string plotRun(const PlotJob& job, const std::function<void(const std::string&)>& note);

}  // namespace rigid_body_sim
