#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/buoyancy.hpp>
#include <rigid_body_sim/dynamics/medium_drag.hpp>

#include "dynamics/methods/catalogue.hpp"
#include "support/random_bodies.hpp"
#include "support/same_state.hpp"
#include "support/worlds.hpp"

/// Bodies in a medium: closed forms, and what every such motion keeps.
namespace rigid_body_sim {
namespace {

using test::Bench;
using Coefficients = MediumDrag::Coefficients;

const Vector3d kMediumGravity{0, 0, -9.81};

Bench thrownInMedium(const Coefficients& drag, const Vector3d& medium, const Vector3d& v,
                     const Vector3d& w = Vector3d::Zero()) {
  Bench bench;
  bench.world.g_W = kMediumGravity;
  bench.add(test::principalBody("ball", 2, {0.1, 0.15, 0.2}), test::tumbling(v, w));
  bench.world.laws.push_back(std::make_shared<MediumDrag>(0, drag, medium));
  return bench;
}

bool isSolvedAlone(const Simulation& sim) {
  return sim.plans().size() == 1 && sim.plans()[0].integrator.empty();
}

/// Steps a bench to its end by auto, which must solve it; looks at every step.
void solveTo(const Bench& bench, double end, double step,
             const std::function<void(const Simulation&)>& look) {
  Simulation sim = bench.simulation("auto", step);
  while (sim.time() < end - 1e-9) {
    sim.step();
    look(sim);
  }
  EXPECT_TRUE(isSolvedAlone(sim));
  EXPECT_EQ(sim.evaluations(), 0);
}

/// Every kind of drag at a centre, and buoyancy, on a body under every kind of held wrench.
Bench everythingInMedium(unsigned seed) {
  Draw draw(seed);
  Bench bench;
  bench.world.g_W = kMediumGravity;
  bench.world.bodies.push_back(draw.box(1));
  bench.initial.bodies.push_back(draw.state(bench.world.bodies[0], 2));
  const auto amount = [&draw] { return draw.uniform(0, 1); };
  const auto amounts = [&] { return Vector3d(amount(), amount(), amount()); };
  Coefficients drag;
  drag.linear = {amount(), amounts()};
  drag.quadratic = {seed % 2 ? amount() : 0.0, amounts()};
  drag.angular = {0.1 * amount(), 0.1 * amounts()};
  drag.center_P = draw.vector(0.2);
  drag.R_PD = draw.attitude().toRotationMatrix();
  bench.world.laws.push_back(std::make_shared<MediumDrag>(0, drag, draw.vector(3)));
  bench.world.laws.push_back(
      std::make_shared<Buoyancy>(0, amount(), draw.vector(0.2), bench.world.g_W));
  for (const std::size_t axes : {kWorld, std::size_t{0}}) {
    PointWrench push;
    push.axes = axes;
    push.point_frame = axes == kWorld && seed % 3 == 0 ? kWorld : 0;
    push.force = draw.vector(2);
    push.torque = draw.vector(0.1);
    push.point = draw.vector(0.2);
    push.start = 0.1234;
    push.end = axes == kWorld ? 0.777 : std::numeric_limits<double>::infinity();
    bench.world.wrenches.push_back(push);
  }
  return bench;
}

double gapOf(const BodyState& a, const BodyState& b) {
  return distanceBetween(a, b) + angleBetween(a.q_WP, b.q_WP) + (a.p_W - b.p_W).norm() +
         (a.L_W - b.L_W).norm();
}

}  // namespace

// v = v_t + (v₀ − v_t) exp(−l t/m),  v_t = w + m g/l
TEST(LinearMediumDrag, ReachesItsTerminalVelocityInWind) {
  Coefficients drag;
  drag.linear.alike = 0.8;
  const Vector3d wind(3, -1, 0.5), v0(1, 2, 8), vt = wind + 2 * kMediumGravity / 0.8;
  solveTo(thrownInMedium(drag, wind, v0, {5, 1, -3}), 8, 0.05, [&](const Simulation& sim) {
    const double t = sim.time(), decay = std::expm1(-0.8 * t / 2);
    const Vector3d v = v0 + (v0 - vt) * decay, x = vt * t - (v0 - vt) * decay * 2 / 0.8;
    const double size = 1 + x.norm();
    EXPECT_LE((sim.body(0).p_W / 2 - v).norm(), 1e-13 * (1 + v.norm())) << t;
    EXPECT_LE((sim.body(0).x_W - x).norm(), 1e-13 * size) << t;
  });
}

// Up: v = v_t tan(atan(v₀/v_t) − g t/v_t); down: −v_t tanh(g (t − t_a)/v_t); v_t² = m g/q
TEST(QuadraticMediumDrag, ThrowsAlongTanAndTanhThroughTheApex) {
  for (bool along_axes : {false, true}) {
    Coefficients drag;
    (along_axes ? drag.quadratic.axes.z() : drag.quadratic.alike) = 0.3;
    const double vt = std::sqrt(2 * 9.81 / 0.3), g = 9.81, v0 = 12;
    const double apex = vt / g * std::atan(v0 / vt),
                 top = vt * vt / g * std::log1p(v0 * v0 / vt / vt) / 2;
    solveTo(thrownInMedium(drag, Vector3d::Zero(), {0, 0, v0}), 4, 0.05,
            [&](const Simulation& sim) {
              const double t = sim.time(), tau = g * (t - apex) / vt;
              const double v = t < apex ? -vt * std::tan(tau) : -vt * std::tanh(tau);
              const double z = t < apex ? top + vt * vt / g * std::log(std::cos(tau))
                                        : top - vt * vt / g * std::log(std::cosh(tau));
              EXPECT_NEAR(sim.body(0).p_W.z() / 2, v, 1e-13) << along_axes << t;
              EXPECT_NEAR(sim.body(0).x_W.z(), z, 1e-13 * (1 + std::abs(z))) << along_axes << t;
            });
  }
}

// From rest, where |u| has its kink.
TEST(QuadraticMediumDrag, FallsFromRestAlongTanh) {
  Coefficients drag;
  drag.quadratic.alike = 0.3;
  const double vt = std::sqrt(2 * 9.81 / 0.3);
  solveTo(thrownInMedium(drag, Vector3d::Zero(), Vector3d::Zero()), 2, 0.05,
          [&](const Simulation& sim) {
            EXPECT_NEAR(sim.body(0).p_W.z() / 2, -vt * std::tanh(9.81 * sim.time() / vt), 1e-13);
          });
}

// Afloat, with the centre of buoyancy b above the centre of mass, which stays: a pendulum of the
// moment ρ V g b, of period 4 √(I/(ρ V g b)) K(sin ½θ₀).
TEST(Buoyancy, SwingsAFloatAsAPendulum) {
  constexpr double b = 0.3, theta = 2;
  Bench bench;
  bench.world.g_W = kMediumGravity;
  BodyFrameMotion motion;
  motion.q_WB = rotationExp(Vector3d(0, theta, 0));
  bench.add(test::principalBody("float", 2, {0.1, 0.15, 0.2}), motion);
  bench.world.laws.push_back(std::make_shared<Buoyancy>(0, 2, Vector3d(0, 0, b), bench.world.g_W));
  double a = 1, g = std::cos(theta / 2);  // K by the arithmetic-geometric mean
  for (int i = 0; i < 10; ++i) {
    const double mean = (a + g) / 2;
    g = std::sqrt(a * g);
    a = mean;
  }
  const double period = 4 * std::sqrt(0.15 / (2 * 9.81 * b)) * M_PI / (2 * a);
  Simulation sim = bench.simulation("auto", period / 100);
  while (sim.steps() < 100) {
    sim.step();
    EXPECT_LE(sim.body(0).x_W.norm(), 1e-14);
    if (sim.steps() == 50) {
      EXPECT_LE(angleBetween(sim.body(0).q_WP, Quaterniond(rotationExp(Vector3d(0, -theta, 0)))),
                1e-13);
    }
  }
  EXPECT_TRUE(isSolvedAlone(sim));
  EXPECT_LE(angleBetween(sim.body(0).q_WP, motion.q_WB), 1e-13);
  EXPECT_LE(sim.body(0).L_W.norm(), 1e-13);
}

// dop853 evaluates the laws themselves; its own error at 1 ms is below the bound.
TEST(Medium, IsSolvedAsAnIntegratorFollowsIt) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const Bench bench = everythingInMedium(seed);
    Simulation sim = bench.simulation("auto", 0.01);
    while (sim.steps() < 100) sim.step();
    EXPECT_TRUE(isSolvedAlone(sim)) << seed;
    const State stepped = bench.run("dop853", 1, 1000);
    EXPECT_LE(gapOf(sim.body(0), stepped.bodies[0]), 2e-11) << seed;
  }
}

TEST(Medium, MovedWithItsBodyChangesNothingElse) {
  const Vector3d w(4, -2, 1);
  for (unsigned seed = 0; seed < 4; ++seed) {
    Bench here = everythingInMedium(2 * seed);
    here.world.wrenches.clear();
    Bench moved = here;
    const double mass = here.world.bodies[0].mass;
    moved.initial.bodies[0].p_W += mass * w;
    const auto& drag = static_cast<const MediumDrag&>(*here.world.laws[0]);
    std::vector<double> own(6);
    drag.setStart(own.data());
    moved.world.laws[0] = std::make_shared<MediumDrag>(
        0, drag.coefficients(), Vector3d(Vector3d(own[0], own[1], own[2]) + w));
    Simulation a = here.simulation("auto", 0.01), b = moved.simulation("auto", 0.01);
    for (int i = 0; i < 100; ++i) {
      a.step();
      b.step();
      BodyState back = b.body(0);
      back.x_W -= w * b.time();
      back.p_W -= mass * w;
      EXPECT_LE(gapOf(a.body(0), back), 2e-12) << seed << i;
    }
  }
}

// Wind does work; buoyancy has a potential.
TEST(Medium, KeepsTheBalance) {
  for (unsigned seed = 0; seed < 4; ++seed) {
    for (const char* name : {"auto", "dop853"}) {
      Simulation sim = everythingInMedium(seed).simulation(name, 0.002);
      sim.trackBalance();
      while (sim.steps() < 500) sim.step();
      const double size = 1 + std::abs(mechanicalEnergy(sim.world(), sim.state()));
      EXPECT_NEAR(sim.balance().energy, 0, 1e-12 * size) << name << seed;
      EXPECT_NEAR(sim.balance().momentum.norm(), 0, 1e-12 * size) << name << seed;
      EXPECT_NEAR(sim.balance().angular_momentum.norm(), 0, 1e-12 * size) << name << seed;
    }
  }
}

// A step is split where a component along an axis changes its sign, so that no order is lost.
TEST(MediumDrag, ConvergesAtTheOrderOfEveryIntegratorThatSupportsIt) {
  Coefficients drag;
  drag.quadratic.axes = {0.5, 1, 2};
  drag.linear.axes = {0.1, 0.2, 0.3};
  drag.center_P = {0.05, 0, 0.1};
  const Bench bench = thrownInMedium(drag, {1, 0, 0}, {3, -1, 5}, {1, 2, -1});
  const State exact = bench.run("auto", 1, 100);
  int supporting = 0;
  for (const Method& method : catalogue()) {
    if (!method.supports(bench.world.laws[0]->needs())) {
      EXPECT_THROW(bench.simulation(method.name, 0.01), std::invalid_argument);
      continue;
    }
    ++supporting;
    std::vector<double> errors;
    for (int steps : {60, 120})
      errors.push_back(gapOf(bench.run(method.name, 1, steps).bodies[0], exact.bodies[0]));
    EXPECT_LT(errors[0], 10 * std::pow(10. / 60, method.order) + 1e-12) << method.name;
    if (errors[1] > 1e-12) {
      EXPECT_GT(errors[0] / errors[1], std::exp2(method.order) / 1.7) << method.name;
    }
  }
  EXPECT_EQ(supporting, 3);
}

TEST(MediumDrag, IsTheSameInEveryDirectionWhereItSaysSo) {
  Draw draw(5);
  for (int k = 0; k < 20; ++k) {
    const Body body = draw.box(1);
    const std::vector<BodyState> states{draw.state(body, 2)};
    const std::vector<const Body*> bodies{&body};
    Coefficients drag;
    drag.linear.alike = 0.7;
    drag.quadratic.alike = 0.3;
    drag.angular.alike = 0.2;
    const double own[6] = {0, 0, 0, 1, 1, 1};
    std::vector<Wrench> medium(1), plain(1);
    MediumDrag(0, drag, Vector3d::Zero()).addWrenches({bodies, states, own}, medium);
    Drag(0, {0.7, 0.3, 0.2}).addWrenches({bodies, states}, plain);
    EXPECT_LE((medium[0].f_W - plain[0].f_W).norm(), 1e-14 * (1 + plain[0].f_W.norm()));
    EXPECT_LE((medium[0].tau_P - plain[0].tau_P).norm(), 1e-14 * (1 + plain[0].tau_P.norm()));
  }
}

TEST(Medium, GoesOnFromAStateWithTheSameBits) {
  test::expectToGoOnTheSame(everythingInMedium(1).simulation("auto", 0.01), {3, 40, 80});
}

}  // namespace rigid_body_sim
