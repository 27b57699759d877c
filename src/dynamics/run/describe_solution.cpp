#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include <rigid_body_sim/dynamics/contact_point.hpp>
#include <rigid_body_sim/dynamics/describe_solution.hpp>

#include "dynamics/methods/pivots.hpp"
#include "dynamics/rotation/free_top.hpp"
#include "dynamics/run/describe_trial.hpp"
#include "dynamics/run/magnified_text.hpp"
#include "dynamics/run/method_choice.hpp"
#include "dynamics/world_changes.hpp"

namespace rigid_body_sim {
namespace {

/// The wrenches that act or are to come, body by body: of the scene, or of a state loaded since.
std::vector<std::vector<PointWrench>> wrenchesByBody(const World& world, const State& state) {
  std::vector<std::vector<PointWrench>> wrenches(world.bodies.size());
  for (const BodySchedule& schedule : state.schedules)
    for (const ScheduledWrench& scheduled : schedule.wrenches)
      wrenches[scheduled.wrench.body].push_back(scheduled.wrench);
  if (state.schedules.empty())
    for (const PointWrench& wrench : world.wrenches) wrenches[wrench.body].push_back(wrench);
  return wrenches;
}

/// Whether each of them, by itself, and gravity leave a body without torque.
bool leaveFree(const World& world, const Body& body, const std::vector<PointWrench>& wrenches) {
  const bool has_lever = body.pivoted && !world.g_W.isZero(0) && !body.com_P.isZero(0);
  return !has_lever && body.actuators.empty() &&
         std::all_of(wrenches.begin(), wrenches.end(), [&](const PointWrench& wrench) {
           HeldWrenchSum sum;
           sum.add(wrench);
           System::Pivot pivot{0, Vector3d::Zero()};
           const HeldWrench held = body.pivoted ? heldOnPivot(body, sum, pivot) : sum.sum();
           return held.torqueFree();
         });
}

std::set<std::size_t> bodiesInMedium(const World& world) {
  std::set<std::size_t> in_medium;
  for (const auto& law : world.laws)
    if (law->isOfMedium()) in_medium.insert(law->members().front());
  return in_medium;
}

/// Names of the laws on each body, each name once; one pass over the laws of the world. which: of
/// all laws, or of those alone that begin to act somewhere.
enum class Which { kAll, kOneSided };
std::vector<std::vector<std::string>> lawNames(const World& world, Which which) {
  std::vector<std::vector<std::string>> names(world.bodies.size());
  for (const auto& law : world.laws) {
    if (rests(*law, world) || (which == Which::kOneSided && !law->isOneSided())) continue;
    for (std::size_t body : law->members()) {
      std::vector<std::string>& of_body = names[body];
      if (std::find(of_body.begin(), of_body.end(), law->name()) == of_body.end())
        of_body.push_back(law->name());
    }
  }
  return names;
}

/// "gravity, spring, drag", or "free".
std::string whatActs(const World& world, const Body& body, const std::vector<std::string>& laws,
                     bool has_wrenches) {
  std::vector<std::string> acting;
  if (!world.g_W.isZero(0)) acting.push_back("gravity");
  acting.insert(acting.end(), laws.begin(), laws.end());
  if (body.pivoted) acting.push_back("pivot");
  if (!body.actuators.empty()) acting.push_back("motors");
  if (has_wrenches) acting.push_back("wrenches");
  if (acting.empty()) return "free";
  std::string text = acting.front();
  for (std::size_t i = 1; i < acting.size(); ++i) text += ", " + acting[i];
  return text;
}

const char* kindOf(const Body& body) {
  switch (FreeTop<double>(body.I).kind()) {
    case InertiaKind::spherical:
      return "spherical";
    case InertiaKind::symmetric:
      return "symmetric";
    case InertiaKind::asymmetric:
      break;
  }
  return "asymmetric";
}

/// "45.7 ms"
std::string stepText(double h) {
  std::ostringstream text;
  text.precision(3);
  text << (h < 1 ? 1e3 * h : h) << (h < 1 ? " ms" : " s");
  return text.str();
}

/// How a body that is solved goes on once one of these laws acts; see MethodPlanner::later.
std::string onceActs(const std::vector<std::string>& laws) {
  if (laws.empty()) return "";
  std::string names = laws.front();
  for (std::size_t i = 1; i < laws.size(); ++i) names += " or " + laws[i];
  return "; once " + names + " acts, " + errorControlled().method->name +
         " by its own error estimates";
}

/// "asymmetric, exact", "Taylor", "dop853 in steps of 1 ms", or in substeps, see describeSolution
std::string howSolved(const World& world, const Body& body, const MotionPlan& plan,
                      bool flies_freely) {
  if (plan.integrator.empty())
    return flies_freely ? std::string(kindOf(body)) + ", exact" : "Taylor";
  if (plan.at_rest) return "at rest";
  std::ostringstream text;
  text << plan.integrator << " in " << (plan.substeps > 1 ? "sub" : "") << "steps of "
       << (plan.by_estimates ? "at most " : "") << stepText(world.solver.time_step / plan.substeps);
  if (plan.substeps > 1) text << " (" << plan.substeps << " per step)";
  if (plan.by_estimates) text << ", shortened where its own error estimates ask for it";
  if (plan.cut_short)
    text << "; from " << plan.tried_until << " s on dop853 by its own error estimates";
  return text.str();
}

/// Says that auto found nothing to hold the tolerance for the group.
std::string shortfall(const World& world, const MotionPlan& plan) {
  std::ostringstream text;
  text << world.bodies[plan.bodies.front()].name;
  if (plan.bodies.size() > 1) text << " and " << plan.bodies.size() - 1 << " with it";
  text << ": no integrator was found to hold tolerance " << world.solver.tolerance << " over "
       << world.solver.horizon << " s at this time step; ";
  constexpr double kAllowed = 0.5;  // of error: with less, it is rounding that takes too much
  if (plan.error <= kAllowed)
    text << "rounding alone makes " << plan.error << " times that, where a trial allows a quarter";
  else if (std::isfinite(plan.error))
    text << "the least error found was " << plan.error
         << " times that, where a trial allows half, and a quarter of rounding";
  else
    text << "no two runs agreed well enough to tell";
  return text.str();
}

/// Of 16 digits half are left where rounding has grown that much.
constexpr double kDigitsLost = 8;

/// [rad per rad] How far apart two free rotations come in a time that start a little apart.
double magnificationOf(const Body& body, const BodyState& start, double duration) {
  constexpr double kApart = 1e-10;  // 1e-15 of what it grows to is rounding
  const FreeTop<double> top(body.I);
  const auto attitude = [&](const Vector3d& L_P) {
    return top.from(start.q_WP, L_P, rotate(start.q_WP, L_P)).at(duration).q_WP;
  };
  const Quaterniond end = attitude(start.L_P);
  double most = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d other = start.L_P + kApart * stableNorm(start.L_P) * Vector3d::Unit(axis);
    most = std::max(most, angleBetween(attitude(other), end) / kApart);
  }
  return most;
}

/// What the free rotation of a body that is solved has magnified since its anchor, where that is
/// much: no digit is lost on the way, but those of its start are spread out.
std::string magnificationOfSolved(const Simulation& simulation) {
  constexpr std::size_t kMax = 100;  // bodies: the node asks once a second
  const World& world = simulation.world();
  if (world.bodies.size() > kMax) return "";
  const State state = simulation.state();
  const auto wrenches = wrenchesByBody(world, state);
  const std::set<std::size_t> in_medium = bodiesInMedium(world);
  double most = 0;
  std::size_t which = 0;
  for (const MotionPlan& plan : simulation.plans()) {
    const std::size_t i = plan.bodies.front();
    const Body& body = world.bodies[i];
    if (!plan.integrator.empty() || FreeTop<double>(body.I).kind() != InertiaKind::asymmetric ||
        in_medium.count(i) > 0 || !leaveFree(world, body, wrenches[i]))
      continue;
    const MotionAnchor anchor = i < state.anchors.size() ? state.anchors[i] : MotionAnchor();
    if (!(anchor.horizon > state.t)) continue;  // not solved yet, or no longer from there
    const double magnification = magnificationOf(body, anchor.state, state.t - anchor.t);
    if (magnification > most) which = i;
    most = std::max(most, magnification);
  }
  if (!(most > std::pow(10, kDigitsLost))) return "";
  return magnifiedText(world.bodies[which], most, SolvedBy::kClosedForm);
}

/// A line for each body, or, of very many, for neighbours with the same line.
std::vector<std::string> linesOf(const World& world, const std::vector<std::string>& texts) {
  constexpr std::size_t kMany = 40;
  std::vector<std::string> lines;
  std::size_t end = 0;
  for (std::size_t i = 0; i < texts.size(); i = end) {
    end = i + 1;
    while (texts.size() > kMany && end < texts.size() && texts[end] == texts[i]) ++end;
    std::string names = world.bodies[i].name;
    if (end - i > 1)
      names += " to " + world.bodies[end - 1].name + " (" + std::to_string(end - i) + " bodies)";
    lines.push_back(names + ": " + texts[i]);
  }
  return lines;
}

}  // namespace

std::string magnifiedText(const Body& body, double magnification, SolvedBy solved) {
  const char* const holds = solved == SolvedBy::kClosedForm
                                ? "it is exact for this start, but no"
                                : "it is that of a start which differs in its last digits, and no";
  return "the motion of body '" + body.name +
         "' has magnified differences of its start, rounding among them, 10^" +
         std::to_string(std::llround(std::log10(magnification))) + " times by now: " + holds +
         " real body starts so exactly";
}

std::vector<std::string> describeSolution(const Simulation& simulation) {
  const World& world = simulation.world();
  const auto laws = lawNames(world, Which::kAll), one_sided = lawNames(world, Which::kOneSided);
  const auto wrenches = wrenchesByBody(world, simulation.state());
  const std::set<std::size_t> in_medium = bodiesInMedium(world);
  std::vector<std::string> texts, shortfalls;
  for (const Body& body : world.bodies) texts.push_back(body.absent ? "absent" : "fixed");
  for (const MotionPlan& plan : simulation.plans()) {
    for (std::size_t i : plan.bodies)
      texts[i] =
          whatActs(world, world.bodies[i], laws[i], !wrenches[i].empty()) + ", " +
          howSolved(world, world.bodies[i], plan,
                    leaveFree(world, world.bodies[i], wrenches[i]) && in_medium.count(i) == 0) +
          (plan.integrator.empty() ? onceActs(one_sided[i]) : "");
    if (!plan.holds) shortfalls.push_back(shortfall(world, plan));
  }
  std::vector<std::string> lines = linesOf(world, texts);
  lines.insert(lines.end(), shortfalls.begin(), shortfalls.end());
  const std::string trial = describeTrial(simulation);
  if (!trial.empty()) lines.push_back(trial);
  return lines;
}

std::string describeSubsteps(const Simulation& simulation) {
  if (simulation.maxSubsteps() == 1) return "";
  std::ostringstream text;
  text << "steps were divided into up to " << simulation.maxSubsteps()
       << " substeps, to follow what turned, swung or slowed down fast";
  const std::string& integrator = simulation.world().solver.integrator;
  if (integrator != "auto")
    text << ": that keeps " << integrator
         << " stable, not accurate; auto bounds the error, trade measures it";
  return text.str();
}

std::string describeMagnification(const Simulation& simulation) {
  std::string of_solved = magnificationOfSolved(simulation);
  if (!of_solved.empty()) return of_solved;
  const double digits = simulation.magnification() / std::log(10.0);
  if (!(digits > kDigitsLost)) return "";
  return simulation.world().solver.integrator +
         " has magnified what a body turns about its axis of least inertia 10^" +
         std::to_string(std::llround(digits)) +
         " times, rounding, too, so that the motion may be wrong: take another integrator, or a "
         "far smaller time_step";
}

std::string describePromise(const Simulation& simulation) {
  const double lost_at = simulation.errorEstimate().lost_at;
  if (!std::isfinite(lost_at)) return "";
  std::ostringstream text;
  text << "from " << lost_at << " s on, tolerance " << simulation.world().solver.tolerance
       << " is not certain to be held: a second run, at looser bounds of its steps, differs from "
          "this one by more than that";
  return text.str();
}

}  // namespace rigid_body_sim
