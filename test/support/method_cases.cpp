#include "support/method_cases.hpp"

#include "dynamics/wrenches/held_wrench.hpp"
#include "support/law_benches.hpp"

namespace rigid_body_sim::test {

Bench freeBody() {
  Bench bench;
  bench.add(principalBody("top", 1, {1, 2, 3}), tumbling({1, 2, 3}, {1, 1.5, 0.5}));
  return bench;
}

Bench coupledBodies() {
  Bench bench = pushedBox(1, 1, 0.1);
  bench.add(principalBody("other", 3, {1, 2, 2.5}), tumbling({0.3, 0.1, 0}, {0.4, 1.2, -0.6}));
  return bench;
}

Bench interruptedPush() {
  Bench bench = pushedBox(kWorld, 0, 0.1);
  bench.world.wrenches[0].start = 0.1234567;
  bench.world.wrenches[0].end = 0.7654321;
  return bench;
}

Bench draggedSpring() {
  Bench bench = boxOnSpring();
  bench.addDrag(0, {0.3, 0.1, 0.2});
  return bench;
}

Bench pushedOnPivot() {
  Bench bench = pushedBox(kWorld, kWorld, 0.1);
  bench.world.bodies[0] = bodyOnPivot("box", {0.05, -0.1, 0.3});
  bench.initial.bodies[0] = toBodyState(bench.world.bodies[0], tumbling({0, 0, 0}, {1, -0.7, 0.4}));
  return bench;
}

Bench bodyHungOnPivoted() {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  bench.add(bodyOnPivot("upper", {0.05, -0.1, 0.3}), tumbling({0, 0, 0}, {1, -0.7, 0.4}));
  BodyFrameMotion motion = tumbling({-0.5, 0.3, 0.2}, {-0.3, 0.5, 0.4});
  motion.x_W = {0.4, 0.3, -1.6};
  bench.add(principalBody("lower", 1, {0.3, 0.2, 0.35}), motion);
  bench.addSpring({0, {0.1, 0.2, -0.3}}, {1, {0, -0.2, 0.25}}, {10, 0, 0.8});
  return bench;
}

std::vector<Case> allCases() {
  return {{"free", freeBody(), true},
          {"world_wrench_at_body_point", pushedBox(kWorld, 0, 0.1)},
          {"world_wrench_at_world_point", pushedBox(kWorld, kWorld, 0.1)},
          {"body_wrench_at_body_point", pushedBox(0, 0, 0.1)},
          {"body_wrench_at_world_point", pushedBox(0, kWorld, 0.05)},
          {"wrench_of_another_body", coupledBodies()},
          {"start_and_end_inside_steps", interruptedPush()},
          {"spring_to_the_world", boxOnSpring()},
          {"spring_between_bodies", springPair()},
          {"damped_spring_to_the_world", boxOnSpring(3)},
          {"damped_spring_between_bodies", springPair(1)},
          {"central_gravity", satellite()},
          {"linear_drag", thrown({0.8, 0, 0}), true},
          {"angular_drag", thrown({0, 0, 1.5})},
          {"quadratic_drag", thrown({0, 0.3, 0}), true},
          {"every_drag", thrown({0.4, 0.2, 1})},
          {"drag_on_a_spring", draggedSpring()},
          {"drag_in_wind", thrownIntoWind()},
          {"buoyancy", afloat()},
          {"on_a_pivot", pushedOnPivot()},
          {"hung_on_a_body_on_a_pivot", bodyHungOnPivoted()}};
}

unsigned needsOf(const Case& c) {
  unsigned needs = 0;
  for (const auto& law : c.bench.world.laws) needs |= law->needs();
  for (const PointWrench& wrench : c.bench.world.wrenches)
    if (!HeldWrench::holds(wrench)) needs |= kCoupling;
  return needs;
}

std::vector<Case> casesFor(const Method& method) {
  std::vector<Case> supported;
  for (const Case& c : allCases())
    if (method.supports(needsOf(c))) supported.push_back(c);
  return supported;
}

}  // namespace rigid_body_sim::test
