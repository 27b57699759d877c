#include <algorithm>
#include <cmath>
#include <sstream>

#include <rigid_body_sim/dynamics/describe_solution.hpp>

#include "dynamics/rotation/rotor.hpp"

namespace rigid_body_sim {
namespace {

/// Whether what the scene applies leaves a body on a free flight, each wrench by itself.
bool fliesFreely(const World& world, std::size_t body) {
  return std::all_of(world.wrenches.begin(), world.wrenches.end(), [body](const PointWrench& w) {
    if (w.body != body) return true;
    HeldWrench held;
    held.add(w);
    return held.torqueFree();
  });
}

bool hasWrenches(const World& world, std::size_t body) {
  return std::any_of(world.wrenches.begin(), world.wrenches.end(),
                     [body](const PointWrench& wrench) { return wrench.body == body; });
}

/// Names of the laws on each body, each name once; one pass over the laws of the world.
std::vector<std::vector<std::string>> lawNames(const World& world) {
  std::vector<std::vector<std::string>> names(world.bodies.size());
  for (const auto& law : world.laws) {
    for (std::size_t body : law->members()) {
      std::vector<std::string>& of_body = names[body];
      if (std::find(of_body.begin(), of_body.end(), law->name()) == of_body.end())
        of_body.push_back(law->name());
    }
  }
  return names;
}

/// "gravity, spring, drag", or "free".
std::string whatActs(const World& world, std::size_t body, const std::vector<std::string>& laws) {
  std::vector<std::string> acting;
  if (!world.g_W.isZero(0)) acting.push_back("gravity");
  acting.insert(acting.end(), laws.begin(), laws.end());
  if (world.bodies[body].drag.any()) acting.push_back("drag");
  if (hasWrenches(world, body)) acting.push_back("wrenches");
  if (acting.empty()) return "free";
  std::string text = acting.front();
  for (std::size_t i = 1; i < acting.size(); ++i) text += ", " + acting[i];
  return text;
}

const char* kindOf(const Body& body) {
  switch (Rotor<double>(body.I).kind()) {
    case InertiaKind::spherical:
      return "spherical";
    case InertiaKind::symmetric:
      return "symmetric";
    case InertiaKind::asymmetric:
      break;
  }
  return "asymmetric";
}

/// "asymmetric, exact", "Taylor", "dop853, h <= 0.5 ms (2 parts a step)"
std::string howSolved(const World& world, std::size_t body, const MethodChoice& choice) {
  if (!choice.method)
    return fliesFreely(world, body) ? std::string(kindOf(world.bodies[body])) + ", exact"
                                    : "Taylor";
  std::ostringstream text;
  const double h = world.solver.time_step / choice.parts;
  text << choice.method->name << ", h <= " << (h < 1 ? 1e3 * h : h) << (h < 1 ? " ms" : " s");
  if (choice.parts > 1) text << " (" << choice.parts << " parts a step)";
  if (choice.controlled) text << " by its own estimates";
  if (choice.cut_short)
    text << ", from " << choice.tried_until << " s on dop853 by its own estimates";
  return text.str();
}

/// Says that auto found nothing to hold the tolerance for the group.
std::string shortfall(const World& world, const Group& group) {
  std::ostringstream text;
  text << world.bodies[group.members().front()].name;
  if (group.members().size() > 1) text << " and " << group.members().size() - 1 << " with it";
  text << ": no method was found to hold tolerance " << world.solver.tolerance << " over "
       << world.solver.horizon << " s at this time step; ";
  if (std::isfinite(group.choice().error))
    text << "the best tried had " << group.choice().error << " times the error allowed";
  else
    text << "no two runs agreed well enough to tell";
  return text.str();
}

}  // namespace

std::vector<std::string> describeSolution(const Simulation& simulation) {
  const World& world = simulation.world();
  const auto laws = lawNames(world);
  std::vector<std::string> lines(world.bodies.size());
  for (std::size_t i = 0; i < lines.size(); ++i) lines[i] = world.bodies[i].name + ": fixed";
  for (const Group& group : simulation.groups()) {
    for (std::size_t i : group.members())
      lines[i] = world.bodies[i].name + ": " + whatActs(world, i, laws[i]) + ", " +
                 howSolved(world, i, group.choice());
    if (!group.choice().holds) lines.push_back(shortfall(world, group));
  }
  return lines;
}

std::string describeParts(const Simulation& simulation) {
  if (simulation.mostParts() == 1) return "";
  std::ostringstream text;
  text << "steps were taken in up to " << simulation.mostParts()
       << " parts, to follow what turned, swung or slowed down fast";
  return text.str();
}

}  // namespace rigid_body_sim
