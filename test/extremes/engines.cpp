#include <algorithm>
#include <cmath>
#include <cstring>
#include <iostream>
#include <stdexcept>

#include "apart.hpp"
#include "benchmark/peers.hpp"
#include "cell_lines.hpp"
#include "sections.hpp"

// Prints what the engines that are installed do in the cells of the map of the extremes, as CSV.
// A program of its own: loading engines must not touch what is measured of ours.
// usage: extremes_engines [SECTION]

namespace rigid_body_sim::extremes {
namespace {

constexpr int kLimit = 10;  // [s] of processor time for a cell

peers::Array3 array(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

Vector3d vector(const peers::Array3& v) { return {v[0], v[1], v[2]}; }

peers::Motion motionOf(const Body& body, const BodyState& s) {
  peers::Motion m;
  m.x_W = array(s.x_W);
  m.v_W = array(s.p_W / body.mass);
  m.q = {s.q_WP.x(), s.q_WP.y(), s.q_WP.z(), s.q_WP.w()};
  m.w_P = array(s.L_P.cwiseQuotient(body.I));
  return m;
}

State stateOf(const Body& body, const peers::Motion& m) {
  State state;
  state.bodies.resize(1);
  BodyState& s = state.bodies[0];
  s.x_W = vector(m.x_W);
  s.p_W = body.mass * vector(m.v_W);
  s.q_WP = Quaterniond(m.q[3], m.q[0], m.q[1], m.q[2]).normalized();
  s.L_P = vector(m.w_P).cwiseProduct(body.I);
  s.L_W = rotate(s.q_WP, s.L_P);
  return state;
}

/// What acts on the body of a bench, each wrench by itself: to add them up is the engine's.
std::vector<peers::Pull> pullsOn(const test::Bench& bench, const peers::Motion& m) {
  const Body& body = bench.world.bodies[0];
  const std::vector<const Body*> bodies{&body};
  const std::vector<BodyState> states = stateOf(body, m).bodies;
  const Quaterniond q_PW = states[0].q_WP.conjugate();
  std::vector<peers::Pull> pulls;
  for (const PointWrench& w : bench.world.wrenches) {
    if (w.start > 0 || std::isfinite(w.end)) throw std::logic_error("a wrench that does not last");
    pulls.push_back({array(toWorldAxes(w, w.force, states)), array(rotate(q_PW, armOf(w, states))),
                     array(toWorldAxes(w, w.torque, states))});
  }
  for (const auto& law : bench.world.laws) {
    std::vector<Wrench> wrenches(1);
    law->addWrenches({bodies, states}, wrenches);
    const Wrench& w = wrenches[0];
    pulls.push_back({array(w.f_W), {}, array(w.tau_W + rotate(states[0].q_WP, w.tau_P))});
  }
  return pulls;
}

peers::Problem problemOf(const test::Bench& bench) {
  if (bench.world.bodies.size() != 1) throw std::logic_error("engines take one body");
  const Body& body = bench.world.bodies[0];
  peers::Problem problem{"", body.mass, array(body.I), motionOf(body, bench.initial.bodies[0])};
  problem.g_W = array(bench.world.g_W);
  if (!bench.world.wrenches.empty() || !bench.world.laws.empty())
    problem.pulls = [&bench](const peers::Motion& m) { return pullsOn(bench, m); };
  return problem;
}

bool isFinite(const peers::Motion& m) {
  const auto within = [](const auto& values) {
    return std::all_of(values.begin(), values.end(), [](double x) { return std::isfinite(x); });
  };
  return within(m.x_W) && within(m.v_W) && within(m.q) && within(m.w_P);
}

/// What of a message names the condition that failed, without places in the engine's sources.
std::string gistOf(std::string message) {
  for (const char* mark : {"Assertion", "assertion", "Error detected by Simbody method "}) {
    const std::size_t begin = message.rfind(mark);
    if (begin != std::string::npos) message.erase(0, begin);
  }
  message.erase(0, message.find_first_not_of('\n'));
  message.resize(std::min(message.find('\n'), message.size()));
  message.resize(std::min(message.find(" ["), message.size()));
  std::replace(message.begin(), message.end(), '`', '\'');
  return message;
}

std::string bytesOf(const peers::Motion& m) {
  return {reinterpret_cast<const char*>(&m), sizeof m};
}

Cell measureEngine(const peers::Stepper& stepper, Cell cell, const test::Bench& bench,
                   const Run& run, const Ends& truth) {
  const peers::Problem problem = problemOf(bench);
  const Outcome outcome =
      doneApart([&] { return bytesOf(stepper.end(problem, run.time_step, run.steps)); }, kLimit);
  cell.said = outcome.fate;
  cell.warned = gistOf(outcome.said);
  if (!cell.said.empty()) return cell;
  peers::Motion end;
  std::memcpy(&end, outcome.result.data(), sizeof end);
  if (!isFinite(end)) {
    cell.said = "NaN";
  } else if (truth.motions.empty()) {
    cell.said = "goes on";  // where nobody knows the truth
  } else {
    compare(bench, stateOf(bench.world.bodies[0], end), truth, cell);
    if (!cell.finite()) cell.said = "goes on";
  }
  return cell;
}

Names enterEngines() {
  std::sort(peers::engines().begin(), peers::engines().end(),
            [](const auto& a, const auto& b) { return std::string(a.name) < b.name; });
  Names names;
  for (const peers::Engine& engine : peers::engines())
    for (const peers::Stepper& stepper : engine.steppers) {
      names.push_back(stepper.name);
      others()[stepper.name] = [stepper](const Cell& cell, const test::Bench& bench, const Run& run,
                                         const Ends& truth) {
        return measureEngine(stepper, cell, bench, run, truth);
      };
    }
  return names;
}

}  // namespace
}  // namespace rigid_body_sim::extremes

int main(int argc, char** argv) {
  using namespace rigid_body_sim::extremes;
  const std::string wanted = argc > 1 ? argv[1] : "";
  try {
    const Names engines = enterEngines();
    if (engines.empty()) throw std::runtime_error("built without any engine");
    bool complete = true;
    std::vector<NamedSection> sections = oneBodySections();
    sections.emplace_back("spring", [](const Names& names) { return springs(names); });
    for (const auto& [name, section] : sections)
      if (wanted.empty() || name == wanted) complete &= print(section(engines));
    return complete ? 0 : 1;
  } catch (const std::exception& failed) {
    std::cerr << failed.what() << "\n";
    return 1;
  }
}
