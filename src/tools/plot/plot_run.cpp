#include "tools/plot/plot_run.hpp"

#include <algorithm>
#include <filesystem>

#include "math/shortest.hpp"
#include "programs/distinct_files.hpp"
#include "programs/make_directory.hpp"
#include "programs/usage.hpp"
#include "scene/message_text.hpp"
#include "tools/plot/bodies_to_draw.hpp"
#include "tools/plot/figures.hpp"

namespace rigid_body_sim {
namespace {

using Note = std::function<void(const std::string&)>;

void requireKnown(const std::vector<std::string>& bodies, const std::vector<std::string>& known) {
  for (const std::string& body : bodies)
    if (std::find(known.begin(), known.end(), body) == known.end())
      throw UsageError("--bodies: the run has no body '" + printable(body) + "'" +
                       didYouMean(body, known) + "; it has " + nameList(known));
}

std::vector<std::string> chosenBodies(const PlotJob& job, const RunData& run, const Note& note) {
  if (!job.bodies.empty()) {
    requireKnown(job.bodies, bodiesOf(run));
    return job.bodies;
  }
  std::vector<std::string> bodies = bodiesToDraw(run);
  const std::size_t moving = movingBodies(run).size();
  if (moving > bodies.size())
    note("the first " + std::to_string(bodies.size()) + " of " + std::to_string(moving) +
         " bodies that move are drawn; --bodies A,B,... chooses others");
  return bodies;
}

std::string timeAxis(const RunData& run) {
  return run.begin == 0 ? "time [s]" : "time since " + shortest(run.begin) + " s [s]";
}

std::string pictureOf(const Figure& figure, const PlotJob& job) {
  return (std::filesystem::path(job.out) / (figure.name + ".svg")).string();
}

void requireDistinctFiles(const PlotJob& job, const std::vector<Figure>& figures) {
  std::vector<NamedFile> files;
  for (const std::string& path : job.files) files.push_back({"a file that is read", path, false});
  for (const Figure& figure : figures)
    files.push_back({"the picture " + figure.name, pictureOf(figure, job), true});
  requireDistinct(files);
}

}  // namespace

std::string plotRun(const PlotJob& job, const Note& note) {
  const RunData run = readRun(job.files);
  for (const std::string& notice : run.notices) note(notice);
  const std::vector<std::string> bodies = chosenBodies(job, run, note);
  const std::string fast = bodyThatTurnsTooFar(run, bodies);
  if (!fast.empty())
    note("body '" + printable(fast) +
         "' turns more than half a turn between two samples: its roll, pitch and yaw may miss "
         "whole turns; a shorter --sample of simulate shows them");
  const std::vector<Figure> figures = figuresOf(run, bodies);
  requireDistinctFiles(job, figures);
  makeDirectory(job.out);
  std::string written;
  for (const Figure& figure : figures) {
    const std::string svg = pictureOf(figure, job);
    drawFigure(figure, timeAxis(run), svg);
    written += (written.empty() ? "wrote " : ", ") + (written.empty() ? svg : figure.name + ".svg");
  }
  return written;
}

}  // namespace rigid_body_sim
