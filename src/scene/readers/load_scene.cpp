#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "dynamics/methods/catalogue.hpp"
#include "scene/build/check_scene.hpp"
#include "scene/files/read_file.hpp"
#include "scene/limits.hpp"
#include "scene/readers/file_type.hpp"
#include "scene/readers/fingerprint.hpp"
#include "scene/readers/read_scene.hpp"
#include "scene/readers/readers.hpp"
#include "scene/readers/suspicious.hpp"

namespace rigid_body_sim {
namespace {

/// A tf frame name: names joined by slashes, none at the front.
std::string readWorldFrame(const Entry& value) {
  const YamlNode& node = value.node();
  std::size_t first = 0;
  for (std::size_t end = 0; end != std::string::npos; first = end + 1) {
    end = node.text().find('/', first);
    if (!isName(node.text().substr(first, end == std::string::npos ? end : end - first)))
      value.failRule("must be a frame name [A-Za-z][A-Za-z0-9_]*, parts joined by /");
  }
  return std::string(node.text());
}

std::vector<BodyDef> readBodies(const Entry& value) {
  const std::string rule = "must be a list of at least one body";
  value.checkCount(kMaxBodies, "bodies");
  std::vector<BodyDef> bodies;
  const std::size_t count = value.node().children().size();
  if (value.node().kind() != YamlNode::Kind::kList || count == 0) value.failRule(rule);
  bodies.reserve(count);
  for (std::size_t i = 0; i < count; ++i) bodies.push_back(readBody(value.item(i)));
  return bodies;
}

std::vector<ForceDef> readForces(const Entry& value) {
  value.checkCount(kMaxForces, "laws");
  std::vector<ForceDef> forces;
  for (const Entry& item : value.items("must be a list of laws")) forces.push_back(readForce(item));
  return forces;
}

std::vector<WrenchDef> readWrenches(const Entry& value) {
  value.checkCount(Simulation::kMaxWrenches, "wrenches");
  std::vector<WrenchDef> wrenches;
  for (const Entry& item : value.items("must be a list of wrenches"))
    wrenches.push_back(readWrench(item));
  return wrenches;
}

std::vector<CommandDef> readCommands(const Entry& value) {
  value.checkCount(Simulation::kMaxCommands, "commands");
  std::vector<CommandDef> commands;
  for (const Entry& item : value.items("must be a list of commands"))
    commands.push_back(readCommand(item));
  return commands;
}

/// auto, or an integrator of the catalogue.
std::string readIntegrator(const Entry& value) {
  std::string name = readText(value);
  try {
    if (name != "auto") methodNamed(name);
  } catch (const std::invalid_argument& e) {
    value.fail(e.what());
  }
  return name;
}

void refuseIdleTolerance(const Entry& root, const Scene& scene) {
  const YamlNode* tolerance = root.node().find("tolerance");
  if (tolerance && scene.integrator != "auto")
    root.child(*tolerance)
        .fail("tolerance goes with integrator auto only, got integrator " + scene.integrator);
}

/// Time is step count times step.
void refuseUncountableSteps(const Entry& root, const Scene& scene) {
  if (scene.horizon / scene.time_step <= kMaxSteps) return;
  std::ostringstream rule;
  rule << "must divide the horizon of " << scene.horizon << " s into at most 2^53 steps";
  root.child(*root.node().find("time_step")).failRule(rule.str());
}

/// Whether a law is contact: then what the shapes of the bodies touch by is read, too.
bool namesContact(const YamlNode& scene) {
  const YamlNode* forces = scene.find("forces");
  const auto isContact = [](const YamlNode& law) {
    const YamlNode* type = law.find("type");
    return type && type->text() == "contact";
  };
  if (!forces) return false;
  const YamlNodes<const YamlNode> laws = forces->children();
  return std::any_of(laws.begin(), laws.end(), isContact);
}

}  // namespace

Scene readScene(const YamlNode& tree, ReadContext& context) {
  static const std::vector<Key<Scene>> keys = {
      {"world_frame", [](const Entry& e, Scene& s) { s.world_frame = readWorldFrame(e); }},
      {"gravity", [](const Entry& e, Scene& s) { s.gravity = readVector3(e, "m/s^2"); }},
      {"medium", [](const Entry& e, Scene& s) { s.medium = readMedium(e); }},
      {"time_step", [](const Entry& e, Scene& s) { s.time_step = readPositive(e, "s"); }, true},
      {"integrator",
       [](const Entry& e, Scene& s) {
         s.integrator = readIntegrator(e);
         s.integrator_line = e.node().line();
       }},
      {"tolerance",
       [](const Entry& e, Scene& s) {
         s.tolerance = readPositive(e, "");
         s.tolerance_stated = true;
       }},
      {"horizon", [](const Entry& e, Scene& s) { s.horizon = readPositive(e, "s"); }},
      {"threads",
       [](const Entry& e, Scene& s) {
         s.threads = static_cast<int>(readWhole(e, 1, SolverOptions::kMaxThreads));
       }},
      {"bodies", [](const Entry& e, Scene& s) { s.bodies = readBodies(e); }, true},
      {"forces", [](const Entry& e, Scene& s) { s.forces = readForces(e); }},
      {"wrenches", [](const Entry& e, Scene& s) { s.wrenches = readWrenches(e); }},
      {"commands", [](const Entry& e, Scene& s) { s.commands = readCommands(e); }},
  };
  const Entry root(context, tree);
  // bodies may name it, and stand before it
  if (const YamlNode* node = tree.find("world_frame"))
    context.world_frame = readWorldFrame(root.child(*node));
  context.has_contact = namesContact(tree);
  Scene scene;
  scene.source = context.source;
  readMapping(root, keys, scene);
  refuseIdleTolerance(root, scene);
  refuseUncountableSteps(root, scene);
  scene.fingerprint = fingerprintOf(tree);
  scene.files.assign(context.files.begin(), context.files.end());
  scene.notices = std::move(context.notices);
  for (std::string& notice : suspicions(context)) scene.notices.push_back(std::move(notice));
  checkScene(scene);
  return scene;
}

Scene parseScene(const std::string& yaml_text, const std::string& source_name,
                 const PackageFinder& find_package) {
  ReadContext context;
  context.source = source_name;
  context.find_package = find_package;
  return readScene(parseYaml(yaml_text, source_name).root, context);
}

Scene loadScene(const std::string& path, const PackageFinder& find_package) {
  requireSceneName(path);
  ReadContext context;
  context.source = path;
  context.directory = std::filesystem::path(path).parent_path();
  context.find_package = find_package;
  const YamlDocument document = parseYaml(readFile(path, "scene file", kMaxSceneBytes), path);
  return readScene(document.root, context);
}

}  // namespace rigid_body_sim
