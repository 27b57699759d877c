#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "scene_texts.hpp"

/// Cases that others published, as doc/accuracy.md tells them. What is true of the tops and the box
/// was computed outside of this package, by Taylor series of Euler's equations in 34 digits.
namespace rigid_body_sim {
namespace {

Simulation publishedCase(const std::string& text) {
  const Scene scene = parseScene(text, "s.yaml");
  const World world = buildWorld(scene);
  return Simulation(world, initialState(scene, world));
}

BodyFrameMotion motionAfter(Simulation& sim, double t, std::size_t body = 0) {
  while (sim.time() < t - 1e-9) sim.step();
  return toBodyFrameMotion(sim.world().bodies[body], sim.body(body));
}

Simulation vanZonsTop(int steps_per_second) {
  std::ostringstream time_step;
  time_step << std::setprecision(17) << 1.0 / steps_per_second;
  return publishedCase("time_step: " + time_step.str() + R"(
bodies:
  - name: top
    mass: 6
    inertia: {ixx: 10, iyy: 20, izz: 26}
    twist: {frame: body, angular: [1, 15, 1]}
)");
}

/// In axes of the body.
Vector3d ratesAfter(Simulation& sim, double t) {
  const BodyFrameMotion m = motionAfter(sim, t);
  return rotateBack(m.q_WB, m.w_W);
}

/// Weights of the derivatives now, a step ago, ….
using AdamsBashforth = std::vector<double>;

const AdamsBashforth kThird{23. / 12, -16. / 12, 5. / 12};
const AdamsBashforth kFifth{1901. / 720, -1387. / 360, 109. / 30, -637. / 360, 251. / 720};

/// The greatest error of the rates of van Zon's top in 10 s [rad/s]. It starts either as JSBSim
/// does, as if the derivative had never been another, or from rates that are exact.
double errorOfRates(const AdamsBashforth& weights, int per_second, bool exact_start) {
  const auto derivative = [](const Vector3d& w) {
    return Vector3d(-6 * w.y() * w.z() / 10, 16 * w.z() * w.x() / 20, -10 * w.x() * w.y() / 26);
  };
  const double h = 1.0 / per_second;
  Simulation truth = vanZonsTop(per_second);
  Vector3d w(1, 15, 1);
  const int before = static_cast<int>(weights.size()) - 1;
  std::vector<Vector3d> past(weights.size(), derivative(w));
  const auto remember = [&] {
    past.insert(past.begin(), derivative(w));
    past.pop_back();
  };
  double worst = 0;
  for (int step = 1; step <= 10 * per_second; ++step) {
    const Vector3d exact = ratesAfter(truth, step * h);
    remember();
    if (exact_start && step <= before) {
      w = exact;
    } else {
      for (std::size_t k = 0; k < weights.size(); ++k) w += h * weights[k] * past[k];
    }
    worst = std::max(worst, (w - exact).cwiseAbs().maxCoeff());
  }
  return worst;
}

/// Of 49 elastic balls of 10 kg that fall 4.9 m to the ground, stepped by semi-implicit Euler at 1
/// ms for 20 s: the mean square of the energy's error [J²], as SimBenchmark defines it.
double errorOfBounces(const std::function<double(double v, double gh)>& rebound) {
  constexpr double g = 9.81, h = 1e-3;
  double z = 5, v = 0, sum = 0;
  for (int step = 0; step < 20000; ++step) {
    const double error = 490 * (0.5 * v * v + g * (z - 5));
    sum += error * error;
    v = z < 0.1 && v < 0 ? rebound(v, g * h) : v - g * h;
    z += h * v;
  }
  return sum / 20000;
}

}  // namespace

// Rounding of 154 rad.
TEST(VanZonTop, TurnsAsItsSeriesSay) {
  Simulation sim = vanZonsTop(10);
  const BodyFrameMotion m = motionAfter(sim, 10);
  const Quaterniond q(-0.80115547653113007736, 0.17783618504593758978, 0.45844158615951027132,
                      0.34110922853543151807);
  EXPECT_LT(angleBetween(m.q_WB, q), 3e-14);
  const Vector3d w_B(-8.9329781478705380939, 10.951523571915611222, 7.1771583276718636693);
  EXPECT_LT((rotateBack(m.q_WB, m.w_W) - w_B).norm(), 3e-13);
}

// Plots of JSBSim's study show errors of 0.83 and 0.063 rad/s at 120 Hz, and a fourth at 240 Hz; it
// ascribes what is left to something else than the schemes. It is their start.
TEST(VanZonTop, JsbsimsErrorIsThatOfItsStart) {
  EXPECT_NEAR(errorOfRates(kThird, 120, false), 0.83, 0.005);
  const double coarse = errorOfRates(kFifth, 120, false), fine = errorOfRates(kFifth, 240, false);
  EXPECT_NEAR(coarse, 0.063, 0.0005);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1);
  const double exact = errorOfRates(kFifth, 120, true);
  EXPECT_LT(exact, coarse / 15);
  EXPECT_NEAR(std::log2(exact / errorOfRates(kFifth, 240, true)), 5, 0.2);
}

// Rounding of 300 rad.
TEST(BrulsTop, IsWhereItsSeriesSay) {
  Simulation sim = publishedCase(R"(gravity: [0, 0, -9.81]
time_step: 0.01
bodies:
  - name: top
    mass: 15
    inertia: {ixx: 0.234375, iyy: 0.46875, izz: 0.234375}
    center_of_mass: [0, 1, 0]
    pivot: {point: [0, 0, 0]}
    twist: {frame: body, angular: [0, 150, -4.61538]}
)");
  EXPECT_NEAR(motionAfter(sim, 0.01).w_W.y(), 149.84739395407446146, 1e-13);
  const BodyFrameMotion m = motionAfter(sim, 2);
  const Quaterniond q(0.1229471350415334671, -0.4910798925500270147, 0.35043003034362096184,
                      -0.78798688755048566932);
  EXPECT_LT(angleBetween(m.q_WB, q), 3e-14);
  EXPECT_NEAR(m.w_W.y(), -106.16380414312444796, 150 * 3e-14);
  const Vector3d com(-0.15041682274564175981, -0.72416559163689507565, -0.67302226956044409605);
  EXPECT_LT((rotate(m.q_WB, Vector3d(Vector3d::UnitY())) - com).norm(), 3e-14);
}

// Rounding of 50 rad, which the separatrix magnifies about tenfold.
TEST(OsrfBoxes, TheComplexOneTurnsAsItsSeriesSay) {
  const Scene scene = loadScene(std::string(RIGID_BODY_SIM_SCENES) + "/boxes_complex.yaml");
  const World world = buildWorld(scene);
  Simulation sim(world, initialState(scene, world));
  const BodyFrameMotion m = motionAfter(sim, 10);
  const Quaterniond q(0.22516456341395816393, -0.61992756249945248828, -0.27702915068719459181,
                      0.69874572364031014072);
  EXPECT_LT(angleBetween(m.q_WB, q), 1e-13);
}

// What ODE and Bullet publish, to all digits: ODE's is the error of the flight alone, and its
// bounces are exact; Bullet's bounces add the velocity of a step.
TEST(SimBenchmark, OdesEnergyErrsInFlightAndNotAtItsBounces) {
  EXPECT_NEAR(errorOfBounces([](double v, double) { return -v; }), 185.027, 5e-4);
  EXPECT_NEAR(errorOfBounces([](double v, double gh) { return -(v - gh); }), 75245.4, 0.05);
}

/// "Rolling" as far as a scene can state it: doc/accuracy.md. Both start at their depth at rest.
std::string rollingScene() {
  return R"(gravity: [0, 0, -9.81]
time_step: 0.01
horizon: 0.6
tolerance: 1.0e-6
bodies:
  - {name: ground, shape: {plane: {}}, fixed: true}
  - {name: box, shape: {box: [20, 20, 1]}, mass: 10, position: [0, 0, 0.4980541111]}
  - {name: ball, shape: {sphere: {radius: 0.5}}, mass: 1, position: [0, 100, 0.4995417392394061]}
forces:
  - {type: contact, between: [box, ground], stiffness: 1.0e+6, dissipation: 1, friction: 0.4}
  - {type: contact, between: [ball, ground], stiffness: 1.0e+6, dissipation: 1, friction: 0.8}
wrenches:
  - {body: box, frame: world, force: [72.3625, 125.33552656270294, -245.25], duration: .inf}
  - {body: ball, frame: world, force: [-0.36925, -0.639559760694808, 0], duration: .inf}
)";
}

/// How much faster than by Coulomb's law alone the box leaves [m/s]: its four corners' bristles
/// yield first, k x + c v up to 0.4 N.
double headStart() {
  constexpr double mass = 10, pull = 144.725, grip = 0.4 * 35 * 9.81, h = 1e-7;
  const double corner = 0.4 * mass * 9.80665 / 1e-5;
  const double k = 4 * corner, c = 4 * 0.4 * std::sqrt(corner * mass);
  double t = 0, x = 0, v = 0;
  for (; k * x + c * v < grip; t += h) {
    v += h * (pull - k * x - c * v) / mass;
    x += h * v;
  }
  return v - 0.7385 * t;
}

// Pushed at 60° from x, as SimBenchmark does it: a pyramid in place of the cone would hold the box
// still.
TEST(SimBenchmark, BoxSlidesAndBallRollsAsCoulombSays) {
  Simulation sim = publishedCase(rollingScene());
  const double t = 0.5, more = 0.1;  // by then it no longer rocks from its start
  const Vector3d along(0.5, std::sqrt(0.75), 0);
  const Vector3d box = motionAfter(sim, t, 1).v_W;
  // no corner carries just a quarter, as friction tilts the box: 3 % more or less
  EXPECT_NEAR(box.dot(along) - 0.7385 * t, headStart(), 0.01 * headStart());
  EXPECT_LT((box - box.dot(along) * along).norm(), 1e-7);
  const Vector3d gain = motionAfter(sim, t + more, 1).v_W - box;
  EXPECT_LT((gain - 0.7385 * more * along).norm(), 1e-7);
  // in the frame of the box, which is accelerated: 5/7 of 0.7385 m/s² backwards
  const BodyFrameMotion ball = motionAfter(sim, t + more, 2);
  EXPECT_LT((ball.v_W + 5 * 0.7385 / 7 * (t + more) * along).norm(), 1e-12);
}

}  // namespace rigid_body_sim
