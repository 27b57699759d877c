#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "sections.hpp"

namespace rigid_body_sim::extremes {
namespace {

std::string messageOf(const std::string& text) {
  try {
    const Scene scene = parseScene(text, "scene.yaml");
    initialState(scene, buildWorld(scene));
  } catch (const SceneError& refused) {
    return refused.what();
  }
  return "";
}

std::string bodyOf(const std::string& mass, const std::string& inertia) {
  return "time_step: 0.01\nbodies:\n  - name: a\n    mass: " + mass + "\n    inertia: " + inertia +
         "\n";
}

std::string optionOf(const std::string& line) {
  return line + "\nbodies:\n  - {name: a, shape: {sphere: {radius: 1}}, mass: 1}\n";
}

std::string wrenchOf(const std::string& times) {
  return optionOf("time_step: 0.01") + "wrenches:\n  - {body: a, frame: world, " + times + "}\n";
}

}  // namespace

Cells refusals() {
  const std::string unit = "{ixx: 1, iyy: 1, izz: 1}";
  const std::vector<std::pair<std::string, std::string>> texts{
      {"needle of ratio 1e16", bodyOf("1", "{ixx: 1.0e-16, iyy: 1, izz: 1}")},
      {"inertia of no body", bodyOf("1", "{ixx: 1, iyy: 1, izz: 2.1}")},
      {"inertia zero", bodyOf("1", "{ixx: 0, iyy: 0, izz: 0}")},
      {"mass zero", bodyOf("0", unit)},
      {"mass 1e400", bodyOf("1.0e400", unit)},
      {"time step 0", optionOf("time_step: 0")},
      {"time step 1e-400", optionOf("time_step: 1.0e-400")},
      {"tolerance 0", optionOf("time_step: 0.01\ntolerance: 0")},
      {"gravity 1e309", optionOf("time_step: 0.01\ngravity: [0, 0, 1.0e309]")},
      {"ball 1 km below the ground",
       "time_step: 0.01\nbodies:\n  - {name: ground, shape: {plane: {}}, fixed: true}\n"
       "  - {name: a, shape: {sphere: {radius: 1}}, mass: 1, position: [0, 0, -1000]}\n"
       "forces:\n  - {type: contact, between: [a, ground], stiffness: 1.0e+6}\n"},
      {"wrench of duration 0", wrenchOf("start: 0, duration: 0")},
      {"wrench of 1e-12 s at 1e6 s", wrenchOf("start: 1.0e6, duration: 1.0e-12")},
      {"wrench of no known duration", wrenchOf("start: 0, duration: .nan")}};
  Cells cells;
  for (const auto& [setting, text] : texts) {
    Cell cell{"refused", setting, "scene"};
    cell.said = messageOf(text);
    cells.push_back(cell);
  }
  return cells;
}

}  // namespace rigid_body_sim::extremes
