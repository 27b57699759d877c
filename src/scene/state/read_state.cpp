#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include <rigid_body_sim/scene/scene_error.hpp>
#include <rigid_body_sim/scene/state_file.hpp>

#include "dynamics/run/contact_bound.hpp"
#include "dynamics/world_changes.hpp"
#include "math/shortest.hpp"
#include "scene/limits.hpp"
#include "scene/state/read_state_body.hpp"
#include "scene/state/state_format.hpp"

namespace rigid_body_sim {
namespace {

/// A part of a state, and the world that it must be of.
template <class T>
struct Part {
  const World& world;
  const BodyIndex& index;
  T value;
};

[[noreturn]] void refuseOther(const Entry& value, const std::string& expected,
                              const std::string& got) {
  value.fail(value.key() + " must be " + expected + ", as in this run, got " + got +
             ": the state is of another run");
}

void requireSolver(const Entry& value, double expected) {
  const double got = readNumber(value, "");
  if (got != expected) refuseOther(value, shortest(expected), shortest(got));
}

void checkSolver(const Entry& value, const World& world, const BodyIndex& index) {
  using Solver = Part<int>;
  static const std::vector<Key<Solver>> keys = {
      {"integrator",
       [](const Entry& e, Solver& s) {
         const std::string got = readText(e), &expected = s.world.solver.integrator;
         if (got != expected) refuseOther(e, expected, got);
       },
       true},
      {"time_step", [](const Entry& e, Solver& s) { requireSolver(e, s.world.solver.time_step); },
       true},
      {"tolerance", [](const Entry& e, Solver& s) { requireSolver(e, s.world.solver.tolerance); },
       true},
      {"horizon", [](const Entry& e, Solver& s) { requireSolver(e, s.world.solver.horizon); },
       true},
      {"tolerance_stated",
       [](const Entry& e, Solver& s) {
         const bool got = readBoolean(e), expected = s.world.solver.tolerance_stated;
         if (got != expected) refuseOther(e, expected ? "true" : "false", got ? "true" : "false");
       },
       true},
  };
  Solver solver{world, index, 0};
  readMapping(value, keys, solver);
}

std::vector<std::size_t> readLawIndices(const Entry& value) {
  std::vector<std::size_t> laws;
  for (const Entry& item : value.items("must be a list of numbers of laws"))
    laws.push_back(readCount(item));
  return laws;
}

std::vector<std::size_t> readBodyNames(const Entry& value, const BodyIndex& index) {
  std::vector<std::size_t> bodies;
  for (const Entry& item : value.items("must be a list of bodies"))
    bodies.push_back(readBodyName(item, index));
  return bodies;
}

int readSubsteps(const Entry& value) {
  const std::size_t substeps = readCount(value);
  if (substeps < 1 || substeps > std::size_t{std::numeric_limits<int>::max()})
    value.failRule("must be a number of substeps");
  return static_cast<int>(substeps);
}

MotionPlan readGroup(const Entry& item, const World& world, const BodyIndex& index) {
  using Group = Part<MotionPlan>;
  static const std::vector<Key<Group>> keys = {
      {"bodies", [](const Entry& e, Group& g) { g.value.bodies = readBodyNames(e, g.index); },
       true},
      {"laws", [](const Entry& e, Group& g) { g.value.laws = readLawIndices(e); }, true},
      {"waiting_laws", [](const Entry& e, Group& g) { g.value.waiting_laws = readLawIndices(e); },
       true},
      {"integrator", [](const Entry& e, Group& g) { g.value.integrator = readText(e); }},
      {"substeps", [](const Entry& e, Group& g) { g.value.substeps = readSubsteps(e); }, true},
      {"by_estimates", [](const Entry& e, Group& g) { g.value.by_estimates = readBoolean(e); },
       true},
      {"at_rest", [](const Entry& e, Group& g) { g.value.at_rest = readBoolean(e); }, true},
      {"holds", [](const Entry& e, Group& g) { g.value.holds = readBoolean(e); }, true},
      {"error", [](const Entry& e, Group& g) { g.value.error = readBound(e, ""); }, true},
      {"tried_until", [](const Entry& e, Group& g) { g.value.tried_until = readBound(e, "s"); },
       true},
      {"cut_short", [](const Entry& e, Group& g) { g.value.cut_short = readBoolean(e); }, true},
  };
  Group group{world, index, {}};
  readMapping(item, keys, group);
  return group.value;
}

/// By their names first: they tell best of which scene a state is.
void readBodies(const Entry& value, const World& world, const BodyIndex& index, State& state) {
  const std::size_t count = world.bodies.size();
  const std::vector<Entry> items = value.items("must be a list of bodies");
  for (std::size_t i = 0; i < items.size() && i < count; ++i) {
    const YamlNode* name = items[i].node().find("name");
    if (name && name->text() != world.bodies[i].name)
      items[i].fail("body " + std::to_string(i + 1) + " must be '" + world.bodies[i].name +
                    "', as in this scene, got '" + printable(std::string(name->text())) +
                    "': the state is of another scene");
  }
  if (items.size() != count)
    value.fail("bodies must be the " + std::to_string(count) + " of this scene, got " +
               std::to_string(items.size()) + ": the state is of another scene");
  state.bodies.resize(count);
  state.anchors.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    if (!world.bodies[i].fixed) state.anchors[i].horizon = -std::numeric_limits<double>::infinity();
  state.schedules.resize(count);
  state.actuators.resize(count);
  state.changes.resize(count);
  for (std::size_t i = 0; i < count; ++i) readStateOfBody(items[i], world, index, i, state);
  for (std::size_t i = 0; i < count; ++i)
    if (state.changes[i].absent.value_or(unchangedBodies(world)[i].absent)) state.anchors[i] = {};
}

void checkFingerprint(const Entry& value, const World& world) {
  if (readTextOrNone(value) != world.fingerprint)
    value.fail(
        "the state is of a scene with the same bodies and other values: a key of the scene has "
        "been changed since, other than its comments");
}

/// Bodies that are integrated are where the state says.
void completeAnchors(State& state) {
  for (std::size_t i = 0; i < state.anchors.size(); ++i) {
    MotionAnchor& anchor = state.anchors[i];
    if (std::isinf(anchor.horizon) && anchor.horizon < 0) {
      anchor.t = state.t;
      anchor.state = state.bodies[i];
    }
  }
}

/// As Simulation::state() leaves them out.
void leaveOutWhatIsEmpty(const World& world, State& state) {
  const auto isEmpty = [](const auto& of_body) { return of_body.empty(); };
  if (std::all_of(state.actuators.begin(), state.actuators.end(), isEmpty)) state.actuators.clear();
  const auto isSame = [](const BodyChange& change) { return !change.any(); };
  if (std::all_of(state.changes.begin(), state.changes.end(), isSame)) state.changes.clear();
  const bool nothing = std::all_of(
      state.schedules.begin(), state.schedules.end(),
      [](const BodySchedule& of) { return of.wrenches.empty() && of.commands.empty(); });
  if (nothing && world.wrenches.empty() && world.commands.empty()) state.schedules.clear();
}

void checkVersion(const Entry& root) {
  const YamlNode* version = root.node().find("version");
  if (!version) root.fail("is no saved state: it must begin with version");
  const Entry value = root.child(*version);
  if (readCount(value) != std::size_t{kStateVersion})
    value.failRule("must be " + std::to_string(kStateVersion) +
                   ", the version that this program reads");
  if (!root.node().find(kLastKey))
    throw SceneError(root.context().source, 0,
                     "is cut short: its last key, " + std::string(kLastKey) + ", is missing");
}

/// Steps are counted from the start of the run.
double readTime(const Entry& value, const World& world) {
  const double t = readNumber(value, "s");
  if (!(t >= 0 && t / world.solver.time_step <= kMaxSteps))
    value.failRule("must be from 0 to 2^53 time steps [s]");
  return t;
}

using Whole = Part<State>;

const std::vector<Key<Whole>>& keysOfState() {
  static const std::vector<Key<Whole>> keys = {
      {"version", [](const Entry&, Whole&) {}, true},
      {"scene", [](const Entry&, Whole&) {}, true},
      {"solver", [](const Entry&, Whole&) {}, true},
      {"time", [](const Entry& e, Whole& s) { s.value.t = readTime(e, s.world); }, true},
      {"bodies", [](const Entry& e, Whole& s) { readBodies(e, s.world, s.index, s.value); }, true},
      {"laws",
       [](const Entry& e, Whole& s) {
         for (const Entry& item : e.items("must be a list of numbers"))
           s.value.laws.push_back(readNumber(item, ""));
       },
       true},
      {"groups",
       [](const Entry& e, Whole& s) {
         if (e.node().kind() == YamlNode::Kind::kEmpty) return;  // nothing moves
         for (const Entry& item : e.items("must be a list of groups"))
           s.value.plans.push_back(readGroup(item, s.world, s.index));
       },
       true},
      {"near_laws", [](const Entry& e, Whole& s) { s.value.near_laws = readLawIndices(e); }, true},
      {"contact_bound",
       [](const Entry& e, Whole& s) {
         s.value.contact_bound = readNumber(e, "");
         if (!(s.value.contact_bound >= contactStepBound(0) && s.value.contact_bound <= 1))
           e.failRule("must be from 1e-16 to 1");
       },
       false},
      {kLastKey,
       [](const Entry& e, Whole&) {
         if (!readBoolean(e)) e.failRule("must be true");
       },
       true},
  };
  return keys;
}

}  // namespace

State parseState(const std::string& text, const std::string& source, const World& world) {
  ReadContext context;
  context.source = source;
  const YamlDocument document = parseYaml(text, source);
  const Entry root(context, document.root);
  checkVersion(root);
  BodyIndex index;
  for (std::size_t i = 0; i < world.bodies.size(); ++i) index[world.bodies[i].name] = i;
  Whole state{world, index, {}};
  readMapping(root, keysOfState(), state);
  checkFingerprint(root.child(*document.root.find("scene")), world);
  checkSolver(root.child(*document.root.find("solver")), world, index);
  completeAnchors(state.value);
  leaveOutWhatIsEmpty(world, state.value);
  return std::move(state.value);
}

}  // namespace rigid_body_sim
