#include <cmath>

#include <gtest/gtest.h>

#include "dynamics/methods/catalogue.hpp"
#include "support/law_benches.hpp"

/// Motions under laws of force against their closed forms.
namespace rigid_body_sim {
namespace {

using test::Bench;
using test::principalBody;
using test::tumbling;

const double kHalfTurn = std::acos(-1.0);

// x = l₀ + e^(−γt) (a cos ωt + γa/ω sin ωt),  γ = c/2m,  ω² = k/m − γ²
TEST(DampedOscillator, FollowsItsClosedForm) {
  constexpr double m = 2, k = 50, c = 1.5, rest = 1, a = 0.3, t = 4;
  Bench bench;
  BodyFrameMotion motion;
  motion.x_W = {rest + a, 0, 0};
  bench.add(principalBody("weight", m, {1, 2, 2.5}), motion);
  bench.addSpring({kWorld, Vector3d::Zero()}, {0, Vector3d::Zero()}, {k, c, rest});
  const double gamma = c / (2 * m), w = std::sqrt(k / m - gamma * gamma);
  const double x =
      rest + a * std::exp(-gamma * t) * (std::cos(w * t) + gamma / w * std::sin(w * t));
  // order 4 and 8 at ωh = 0.05 over 20 rad; auto: its tolerance of 1e-9 times a path of about 2 m
  EXPECT_NEAR(bench.run("rk4", t, 400).bodies[0].x_W.x(), x, 2e-7);
  EXPECT_NEAR(bench.run("dop853", t, 400).bodies[0].x_W.x(), x, 1e-13);
  EXPECT_NEAR(bench.run("auto", t, 400).bodies[0].x_W.x(), x, 2e-9);
}

/// The integrators that support drag, and auto.
std::vector<std::string> integratorsWithDrag() {
  std::vector<std::string> names{"auto"};
  for (const Method& method : catalogue())
    if (method.supports(kDrag)) names.push_back(method.name);
  return names;
}

// Within e^(−20) of it after 20 times m/c; exact for every integrator, since the rate is zero
// there.
TEST(Drag, LetsEveryIntegratorFallAtTheTerminalVelocity) {
  const double g = 9.81, m = 1;
  for (const std::string& integrator : integratorsWithDrag()) {
    Bench linear = test::thrown({2, 0, 0}), quadratic = test::thrown({0, 0.5, 0});
    const Vector3d v_linear = linear.run(integrator, 10, 500).bodies[0].p_W / m;
    EXPECT_LE((v_linear - Vector3d(0, 0, -g * m / 2)).norm(), 1e-7) << integrator;
    const Vector3d v_quadratic = quadratic.run(integrator, 20, 1000).bodies[0].p_W / m;
    EXPECT_LE((v_quadratic - Vector3d(0, 0, -std::sqrt(g * m / 0.5))).norm(), 1e-9) << integrator;
  }
}

// v = −V tanh(gt/V),  z = −V²/g ln cosh(gt/V)
TEST(Drag, FollowsTheClosedFormsOfAFall) {
  constexpr double g = 9.81, c = 0.05, t = 3;
  Bench bench;
  bench.world.g_W = {0, 0, -g};
  bench.add(principalBody("stone", 1, {1, 2, 2.5}), BodyFrameMotion());
  bench.addDrag(0, {0, c, 0});
  const double V = std::sqrt(g / c);
  const BodyState end = bench.run("dop853", t, 300).bodies[0];
  EXPECT_NEAR(end.p_W.z(), -V * std::tanh(g * t / V), 1e-12);
  EXPECT_NEAR(end.x_W.z(), -V * V / g * std::log(std::cosh(g * t / V)), 1e-12);
}

// ω = ω₀ e^(−ct/I); exact but for rounding where drag has a flow of its own.
TEST(Drag, LetsTheSpinOfABallDecayExponentially) {
  Bench bench;
  const Vector3d w(1, -2, 3);
  bench.add(principalBody("ball", 1, {0.4, 0.4, 0.4}), tumbling(Vector3d::Zero(), w));
  bench.addDrag(0, {0, 0, 0.2});
  for (const std::string& integrator : integratorsWithDrag()) {
    const BodyState end = bench.run(integrator, 5, 500).bodies[0];
    const Vector3d expected = 0.4 * std::exp(-0.2 * 5 / 0.4) * w;
    EXPECT_LE((end.L_P - expected).norm(), integrator == "rk4" ? 1e-8 : 1e-9) << integrator;
    if (integrator != "auto" && integrator != "rk4" &&
        integrator != "dop853") {  // made of impulses
      EXPECT_LE((end.L_P - expected).norm(), 1e-13) << integrator;
    }
  }
}

/// (v × L)/mu − r/|r|, along the major axis, of the length of the eccentricity.
Vector3d laplaceVector(const BodyState& s, double m, double mu) {
  const Vector3d r = s.x_W + s.x_low_W, v = s.p_W / m;
  return v.cross(r.cross(v)) / mu - r.normalized();
}

// 100 revolutions of eccentricity 0.3, 200 steps each. Order 8 leaves an energy error of some 1e-12
// that does not grow; the direction of the axis drifts with it.
TEST(KeplerOrbit, KeepsItsInvariantsOverAHundredRevolutions) {
  constexpr double mu = 1, m = 2, e = 0.3;
  Bench bench;
  BodyFrameMotion perihelion;
  perihelion.x_W = {1 - e, 0, 0};
  perihelion.v_W = {0, std::sqrt(mu * (1 + e) / (1 - e)), 0};
  bench.add(principalBody("planet", m, {1, 2, 3}), perihelion);
  bench.addCentralGravity(0, Vector3d::Zero(), mu, false);
  const BodyState start = bench.initial.bodies[0];
  const double E = mechanicalEnergy(bench.world, bench.initial);
  EXPECT_NEAR(E, -0.5 * mu * m, 1e-15);  // a = 1
  EXPECT_NEAR(laplaceVector(start, m, mu).norm(), e, 1e-15);
  for (const char* integrator : {"kahan_li8", "blanes_moan6", "dop853"}) {
    const State end = bench.run(integrator, 100 * 2 * kHalfTurn, 20000);
    const BodyState& s = end.bodies[0];
    EXPECT_NEAR(mechanicalEnergy(bench.world, end), E, 1e-10) << integrator;
    EXPECT_LE((s.x_W.cross(s.p_W) - start.x_W.cross(start.p_W)).norm(), 1e-10) << integrator;
    EXPECT_LE((laplaceVector(s, m, mu) - laplaceVector(start, m, mu)).norm(), 1e-9) << integrator;
    EXPECT_LE((s.x_W - start.x_W).norm(), 1e-7) << integrator;
  }
}

/// Complete elliptic integral of the first kind by the arithmetic-geometric mean.
double completeK(double k) {
  double a = 1, b = std::sqrt(1 - k * k);
  while (a - b > 1e-15) {
    const double mean = 0.5 * (a + b);
    b = std::sqrt(a * b);
    a = mean;
  }
  return kHalfTurn / (a + b);
}

// On a circular orbit of rate n, pitch about the orbit normal obeys θ'' + 3 n² σ sin θ cos θ = 0,
// σ = (I_roll − I_yaw)/I_pitch: sin θ = sin θ_m cd(n √(3σ) t, sin θ_m). Asked at 10¼ periods, where
// θ passes through zero and shows any error of the period.
TEST(GravityGradient, LibratesWithItsPeriod) {
  constexpr double mu = 1, n = 1, amplitude = 0.4;
  const Vector3d I(1, 2.5, 3);  // yaw along the radius, roll along the track, pitch normal
  const double sigma = (I.y() - I.x()) / I.z();
  BodyFrameMotion motion;
  motion.x_W = {1, 0, 0};
  motion.v_W = {0, n, 0};
  motion.q_WB = Quaterniond(Eigen::AngleAxisd(amplitude, Vector3d::UnitZ()));
  motion.w_W = {0, 0, n};
  // wheels that stand still, about axes in the plane of the motion, are so much more of the body
  for (const std::vector<Actuator>& wheels :
       {std::vector<Actuator>(),
        {{"wheel", Wheel{Vector3d::UnitX(), 0.6}}, {"other", Wheel{Vector3d(0.6, 0.8, 0), 0.4}}}}) {
    Bench bench;
    bench.add(makeBody("satellite", {1, Vector3d::Zero(), I.asDiagonal()}, wheels), motion);
    bench.addCentralGravity(0, Vector3d::Zero(), mu, true);
    const double period = 4 * completeK(std::sin(amplitude)) / (n * std::sqrt(3 * sigma));
    const BodyState s = bench.run("dop853", 10.25 * period, 5000).bodies[0];
    const Vector3d radial_B =
        toBodyFrameMotion(bench.world.bodies[0], s).q_WB.inverse() * Vector3d(s.x_W.normalized());
    EXPECT_NEAR(std::atan2(radial_B.y(), radial_B.x()), 0, 1e-10) << wheels.size() << " wheels";
  }
}

/// A top that stands on a stiff spring at its tip, spinning at `spin` times the rate above which an
/// upright top sleeps:  ω² = 4 m g l I₁/I₃², I₁ about the tip. Returns its greatest tilt [rad] in
/// 12 s, started at 1e-4 rad.
double greatestTilt(double spin) {
  constexpr double m = 1, g = 9.81, l = 0.2, k = 1e5, tilt = 1e-4;
  const Vector3d I(0.004, 0.004, 0.006);
  const double I_tip = I.x() + m * l * l;
  Bench bench;
  bench.world.g_W = {0, 0, -g};
  BodyFrameMotion motion;
  motion.q_WB = Quaterniond(Eigen::AngleAxisd(tilt, Vector3d::UnitX()));
  motion.x_W = motion.q_WB * Vector3d(0, 0, l) - Vector3d(0, 0, m * g / k);
  const double w = spin * std::sqrt(4 * m * g * l * I_tip) / I.z();
  motion.w_W = motion.q_WB * Vector3d(0, 0, w);
  bench.add(principalBody("top", m, I), motion);
  bench.addSpring({kWorld, Vector3d::Zero()}, {0, {0, 0, -l}}, {k, 0, 0});
  Simulation sim = bench.simulation("dop853", 1e-3);
  double greatest = 0;
  for (int i = 0; i < 12000; ++i) {
    sim.step();
    const Vector3d axis_W = rotate(sim.body(0).q_WP, Vector3d(Vector3d::UnitZ()));
    greatest = std::max(greatest, std::atan2(axis_W.head<2>().norm(), axis_W.z()));
  }
  return greatest;
}

// Below the threshold a tilt grows as e^(0.3 t √(mgl/I₁)), above it swings by 3 times its start;
// the spring gives way by m g/k l = 5e-4, which shifts the threshold by less than the 5 % kept from
// it.
TEST(SleepingTop, SleepsAboveItsThresholdAndWakesBelow) {
  EXPECT_LT(greatestTilt(1.05), 1e-3);
  EXPECT_GT(greatestTilt(0.95), 0.1);
}

// An isolated pair, step by step: forces cancel to the bit; angular momentum is kept by the
// integrators whose kicks and drifts each keep it, but for the rounding of 1000 steps.
TEST(SpringPair, KeepsItsMomentum) {
  const auto momentum = [](const State& s) { return Vector3d(s.bodies[0].p_W + s.bodies[1].p_W); };
  const auto angularMomentum = [](const State& s) {
    Vector3d sum = Vector3d::Zero();
    for (const BodyState& b : s.bodies) sum += (b.x_W + b.x_low_W).cross(b.p_W) + b.L_W;
    return sum;
  };
  for (bool damped : {false, true}) {
    const Bench pair = test::springPair(damped ? 1 : 0);
    for (const Method& method : catalogue()) {
      if (!method.supports(damped ? kCoupling | kDamping : kCoupling)) continue;
      const State end = pair.run(method.name, 10, 1000);
      EXPECT_LE((momentum(end) - momentum(pair.initial)).norm(), 1e-13) << method.name;
      if (!method.claimsTo(kKeepsFreeL)) continue;
      EXPECT_LE((angularMomentum(end) - angularMomentum(pair.initial)).norm(), 1e-12)
          << method.name;
    }
  }
}

// To bodies that no law links it makes no difference.
TEST(SpringPair, MovesTheSameBesideOthers) {
  const Bench alone = test::springPair(1);
  Bench among;
  among.add(principalBody("other", 1, {1, 2, 3}), tumbling({0, 0, 0}, {1, 2, 3}));
  for (std::size_t i = 0; i < 2; ++i) {
    among.world.bodies.push_back(alone.world.bodies[i]);
    among.initial.bodies.push_back(alone.initial.bodies[i]);
  }
  among.world.laws.push_back(
      alone.world.laws[0]->reindexed([](std::size_t body) { return body + 1; }));
  const State a = alone.run("dop853", 1, 100), b = among.run("dop853", 1, 100);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(a.bodies[i].x_W, b.bodies[i + 1].x_W);
    EXPECT_EQ(a.bodies[i].q_WP.coeffs(), b.bodies[i + 1].q_WP.coeffs());
  }
}

}  // namespace
}  // namespace rigid_body_sim
