#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "support/run_command.hpp"
#include "support/temporary_directory.hpp"

namespace rigid_body_sim::test {

/// A ball that is pushed for a second, and falls.
inline const std::string kPushedBall = R"(gravity: [0, 0, -10]
time_step: 0.01
horizon: 2
bodies:
  - {name: ball, shape: {sphere: {radius: 0.1}}, mass: 2, twist: {frame: world, linear: [0, 0, 5], angular: [0, 0, 1]}}
wrenches:
  - {body: ball, frame: world, force: [3, 0, 0], start: 0, duration: 1}
)";

/// A ball that falls on the ground in steps so long that nothing tells the error.
inline const std::string kDoubtfulBall = R"(gravity: [0, 0, -10]
time_step: 0.6
horizon: 1
bodies:
  - {name: ground, shape: {plane: {}}, fixed: true}
  - {name: ball, shape: {sphere: {radius: 0.1}}, mass: 2, position: [0, 0, 1]}
forces: [{type: contact, between: [ball, ground], stiffness: 1e4}]
)";

inline Outcome sweep(const std::string& arguments, const std::string& environment = "") {
  return runCommand(environment + " " + RIGID_BODY_SIM_SWEEP + " " + arguments + " 2>&1");
}

/// A scene and a study in files, and where a sweep of them goes.
struct SweepFiles {
  SweepFiles(const std::string& scene_text, const std::string& study_text)
      : scene(files.written("scene.yaml", scene_text)),
        study(files.written("study.yaml", study_text)) {}

  std::string command() const { return scene + " " + study + " --out " + out; }

  /// Without a plot, on one thread, by a shell that first does what stands before.
  Outcome sweepAfter(const std::string& before, const std::string& options) const {
    return runCommand("bash -c '" + before + " PATH=/nonexistent " RIGID_BODY_SIM_SWEEP " " +
                      command() + " --threads 1 " + options + " 2>&1'");
  }

  TemporaryDirectory files{};
  std::string scene, study;
  std::string out = files.path("out"), table = out + "/runs.csv";
};

inline std::string fileText(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

/// The columns of a table by their names.
inline std::map<std::string, std::vector<std::string>> tableAt(const std::string& path) {
  std::ifstream in(path);
  std::string line, field;
  std::vector<std::string> names;
  std::map<std::string, std::vector<std::string>> table;
  std::getline(in, line);
  for (std::istringstream row(line); std::getline(row, field, ',');) names.push_back(field);
  while (std::getline(in, line)) {
    std::istringstream row(line);
    for (const std::string& name : names) {
      field.clear();
      std::getline(row, field, ',');
      table[name].push_back(field);
    }
  }
  return table;
}

inline std::vector<double> numbersOf(const std::vector<std::string>& fields) {
  std::vector<double> numbers;
  for (const std::string& field : fields) numbers.push_back(std::stod(field));
  return numbers;
}

}  // namespace rigid_body_sim::test
