#include "support/law_benches.hpp"

namespace rigid_body_sim::test {

Bench boxOnSpring(double damping) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  bench.add(principalBody("box", 2, {0.5, 0.7, 0.9}), tumbling({0.5, 0.2, 0}, {1, -0.7, 0.4}));
  bench.addSpring({kWorld, {0.2, -0.1, 1.5}}, {0, {0.3, 0.1, 0.2}}, {40, damping, 0.6});
  return bench;
}

Bench springPair(double damping) {
  Bench bench;
  bench.add(principalBody("upper", 2, {0.5, 0.7, 0.9}), tumbling({0.3, 0, -0.2}, {0.5, -0.7, 0.4}));
  BodyFrameMotion motion = tumbling({-0.5, 0.3, 0.2}, {-0.3, 0.5, 0.4});
  motion.x_W = {0.4, 0.3, -1.6};
  bench.add(principalBody("lower", 1, {0.3, 0.2, 0.35}), motion);
  bench.addSpring({0, {0.1, 0.2, -0.3}}, {1, {0, -0.2, 0.25}}, {5, damping, 0.8});
  return bench;
}

Bench satellite() {
  Bench bench;
  BodyFrameMotion motion = tumbling({0, 1.1, 0.1}, {0.3, -0.2, 1});
  motion.x_W = {1.2, -0.1, 0.4};
  bench.add(principalBody("satellite", 3, {1, 2.5, 3}), motion);
  bench.addCentralGravity(0, {0.2, -0.1, 0.4}, 1.3, true);
  return bench;
}

Bench thrown(const Drag::Coefficients& drag) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  bench.add(principalBody("feather", 1, {1, 2, 2.5}), tumbling({3, -1, 2}, {1, 1.5, 0.5}));
  bench.addDrag(0, drag);
  return bench;
}

Bench thrownIntoWind() {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  bench.add(principalBody("dart", 2, {0.5, 0.7, 0.9}), tumbling({3, -1, 2}, {1, 1.5, 0.5}));
  MediumDrag::Coefficients drag;
  drag.linear = {0.1, {0.1, 0.2, 0.4}};
  drag.quadratic.alike = 0.05;
  drag.angular.alike = 0.2;
  drag.center_P = {-0.3, 0.05, 0.1};
  bench.addMediumDrag(0, drag, {-2, 5, 1});
  return bench;
}

Bench afloat() {
  Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  bench.add(principalBody("float", 2, {0.5, 0.7, 0.9}), tumbling({0.5, 0, 0.2}, {1, -0.7, 0.4}));
  bench.addBuoyancy(0, 1.5, {0.05, -0.1, 0.3});
  return bench;
}

}  // namespace rigid_body_sim::test
