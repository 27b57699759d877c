#include "dynamics/methods/catalogue.hpp"

#include <limits>
#include <stdexcept>

namespace rigid_body_sim {

const std::vector<Method>& catalogue() {
  // most turn: where the energy error of a free body passes about 1e-2, or the order is left
  // cost: measured by test/benchmark/step_cost.cpp
  constexpr double kAnyTurn = std::numeric_limits<double>::infinity();
  constexpr unsigned kGeometric = kReversible | kBoundsEnergy | kKeepsFreeL;
  // of the splittings, those without negative steps support drag: backwards, drag grows without
  // bounds
  constexpr unsigned kUndamped = kCoupling | kDrag | kLawStates;
  constexpr unsigned kAll = kUndamped | kDamping;
  constexpr unsigned kMotors = kThrust | kSpin;
  // clang-format off
  static const std::vector<Method> methods{
      // name               order free eval turn  cost  claims           supports step
      {"semi_implicit_euler", 1, 1,  1, 0.8,  0.9, kKeepsFreeL | kFeedsLeastAxis, kAll | kThrust, semiImplicitEulerStep},
      {"strang",              2, 2,  1, 0.8,  1,   kGeometric, kUndamped | kThrust, strangStep},
      {"magnus4",             2, 4,  1, 0.4,  1,   kKeepsFreeL, kUndamped | kThrust, magnus4Step},
      {"rk4",                 4, 4,  4, 0.4,  1.9, 0,                    kAll | kMotors,      rk4Step},
      {"blanes_moan6",        6, 0, 14, 1.6, 56,   kGeometric,           kCoupling, blanesMoan6Step},
      {"kahan_li8",           8, 8, 17, 0.8, 15,   kGeometric,           kCoupling, kahanLi8Step},
      {"dop853",              8, 8, 12, 1.6,  6.6, kEstimatesError,           kAll | kMotors | kContact,  dop853Step},
      {"taylor",             16, 16, 1, kAnyTurn, 2.1, kSolves | kKeepsFreeL, kMotors,    taylorStep},
  };
  // clang-format on
  return methods;
}

std::string methodsThatSupport(unsigned needs) {
  std::string names;
  for (const Method& method : catalogue())
    if (method.supports(needs)) names += (names.empty() ? "" : ", ") + std::string(method.name);
  return names;
}

void requireSupport(const Method& method, unsigned needs, const std::string& body,
                    unsigned needs_of_world) {
  if (method.supports(needs)) return;
  const unsigned refused = needs & ~method.supported;
  std::string what = "laws or wrenches that couple bodies";
  if (refused & kDrag) what = "drag";
  if (refused & kDamping) what = "damping";
  if (refused & kLawStates) what = "laws with states of their own";
  if (refused & kContact) what = "contact";
  if (refused & kThrust) what = "motors";
  if (refused & kSpin) what = "wheels and rotors with inertia";
  throw std::invalid_argument("integrator must be auto or support " + what + ", as body '" + body +
                              "' needs (" + methodsThatSupport(needs | needs_of_world) +
                              "), got '" + method.name + "'");
}

const Method& methodNamed(const std::string& name) {
  std::string known;
  for (const Method& method : catalogue()) {
    if (name == method.name) return method;
    known += std::string(known.empty() ? "" : ", ") + method.name;
  }
  throw std::invalid_argument("integrator must be one of auto, " + known + ", got '" + name + "'");
}

}  // namespace rigid_body_sim
