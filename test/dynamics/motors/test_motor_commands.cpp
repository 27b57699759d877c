#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "support/motor_benches.hpp"
#include "support/refusal.hpp"

/// Commands: their instants, limits and ends; what a state keeps of them; who is refused.
namespace rigid_body_sim {
namespace {

using namespace test;

Bench motleyBench() { return benchOf(motley(), motleyStart()); }

void expectSameBits(const State& a, const State& b) {
  EXPECT_EQ(a.bodies[0].x_W, b.bodies[0].x_W);
  EXPECT_EQ(a.bodies[0].x_low_W, b.bodies[0].x_low_W);
  EXPECT_EQ(a.bodies[0].q_WP.coeffs(), b.bodies[0].q_WP.coeffs());
  EXPECT_EQ(a.bodies[0].p_W, b.bodies[0].p_W);
  EXPECT_EQ(a.bodies[0].L_W, b.bodies[0].L_W);
  EXPECT_EQ(a.bodies[0].L_P, b.bodies[0].L_P);
  ASSERT_EQ(a.actuators[0].size(), b.actuators[0].size());
  for (std::size_t k = 0; k < a.actuators[0].size(); ++k) {
    EXPECT_EQ(a.actuators[0][k].command, b.actuators[0][k].command) << k;
    EXPECT_EQ(a.actuators[0][k].value, b.actuators[0][k].value) << k;
    EXPECT_EQ(a.actuators[0][k].since, b.actuators[0][k].since) << k;
  }
}

void stepTo(Simulation& sim, std::int64_t steps) {
  while (sim.steps() < steps) sim.step();
}

std::string refusalOf(Simulation& sim, const ActuatorCommand& command) {
  return test::refusalOf([&] { sim.apply(CommandInput{command}); });
}

}  // namespace

TEST(MotorCommands, ScheduledAndSentCommandsGiveTheSameBits) {
  Bench scheduled = motleyBench();
  scheduled.world.commands = {commandOf(1, 30, 0.1), commandOf(0, 5, 0.5),
                              commandOf(2, 0.2, 0.6543)};
  Simulation sim = scheduled.simulation("auto", 0.01);
  Simulation sent = motleyBench().simulation("auto", 0.01);
  stepTo(sent, 10);
  sent.apply(CommandInput{commandOf(1, 30, 0)});  // past: now
  stepTo(sent, 37);
  sent.apply(CommandInput{commandOf(2, 0.2, 0.6543)});
  sent.apply(CommandInput{commandOf(0, 5, 0.5)});
  stepTo(sent, 100);
  stepTo(sim, 100);
  expectSameBits(sim.state(), sent.state());
}

// as by a pilot that publishes it a hundred times a second
TEST(MotorCommands, SaidAgainChangeNothing) {
  for (const double value : {0.0, 25.0}) {
    Bench once = motleyBench(), often = once;
    once.world.commands = {commandOf(0, value, 0), commandOf(1, value, 0)};
    for (int k = 0; k < 1500; ++k)
      for (const std::size_t motor : {0u, 1u})
        often.world.commands.push_back(commandOf(motor, value, 0.01 * k));
    Simulation one = once.simulation("auto", 0.01), many = often.simulation("auto", 0.01);
    stepTo(one, 1500);
    stepTo(many, 1500);
    const State a = one.state(), b = many.state();
    for (std::size_t motor : {0u, 1u}) {
      EXPECT_EQ(b.actuators[0][motor].value, value);  // the lag has ended
      EXPECT_EQ(a.actuators[0][motor].since, b.actuators[0][motor].since);
    }
    // 1500 pieces of the motion beside a few, each rounded
    EXPECT_LT((a.bodies[0].q_WP.coeffs() - b.bodies[0].q_WP.coeffs()).norm(), 1e-12);
    EXPECT_LT((a.bodies[0].p_W - b.bodies[0].p_W).norm(), 1e-12 * a.bodies[0].p_W.norm());
  }
}

// 708 time constants of a thruster and 354 of a rotor, whose thrust is squared, are 1e-308
TEST(MotorCommands, MayKeepALagGoingUntilItUnderflows) {
  Bench bench = motleyBench();
  for (int k = 0; k < 2000; ++k)
    for (const std::size_t motor : {0u, 1u})
      bench.world.commands.push_back(commandOf(motor, k % 2 * 1e-310, 0.1 * k));
  Simulation sim = bench.simulation("auto", 0.1);
  stepTo(sim, 2000);
  EXPECT_LT(std::abs(sim.state().actuators[0][0].value), 1e-300);
  EXPECT_TRUE(sim.body(0).q_WP.coeffs().allFinite());
}

TEST(MotorCommands, ARunCutInTwoHasTheSameBits) {
  Bench bench = motleyBench();
  bench.world.commands = {commandOf(1, -30, 0.105), commandOf(0, 5, 0.2), commandOf(3, 0.2, 0.25)};
  for (const char* integrator : {"auto", "dop853"}) {
    Simulation whole = bench.simulation(integrator, 0.01);
    stepTo(whole, 23);
    Simulation second(whole.world(), whole.state());
    stepTo(whole, 90);
    stepTo(second, 90);
    expectSameBits(whole.state(), second.state());
  }
}

TEST(MotorCommands, ReadingAndSamplingChangeNoBit) {
  Bench bench = motleyBench();
  bench.world.commands = {commandOf(1, -30, 0.105), commandOf(0, 5, 0.2001)};
  Simulation sim = bench.simulation("auto", 0.01), read = bench.simulation("auto", 0.01);
  while (read.steps() < 60) {
    const State between = read.sample(read.time() + 0.004);
    ASSERT_EQ(readActuators(read.world().bodies[0], between, 0).size(), 4u);
    read.state();
    read.actuators(0);
    read.step();
    sim.step();
  }
  expectSameBits(sim.state(), read.state());
}

// z = Ω|Ω| is read between steps, where a command falls due within the step.
TEST(MotorCommands, SamplesShowCommandsWithinTheStep) {
  Bench bench = benchOf(quadrotor(), BodyFrameMotion());
  bench.world.commands = {commandOf(0, 500, 0.003)};
  const Simulation sim = bench.simulation("auto", 0.01);
  const Body& body = sim.world().bodies[0];
  EXPECT_EQ(readActuators(body, sim.sample(0.002), 0)[0].speed, 0);
  const ActuatorReading now = readActuators(body, sim.sample(0.008), 0)[0];
  const double speed = -500 * std::expm1(-0.005 / 0.03);
  EXPECT_NEAR(now.speed, speed, 1e-12);
  EXPECT_NEAR(now.force, 8.5e-6 * speed * speed, 1e-14);
  EXPECT_NEAR(now.torque, -1.4e-7 * speed * speed, 1e-15);
  EXPECT_EQ(now.command, 500);
}

TEST(MotorCommands, BeyondTheLimitsAreHeldThereAndCounted) {
  Simulation sim = benchOf(quadrotor(), BodyFrameMotion()).simulation("auto", 0.01);
  sim.command(commandOf(0, 5000, 0));
  sim.command(commandOf(1, -5000, 0.005));
  sim.command(commandOf(2, 1100, 0));
  EXPECT_EQ(sim.actuators(0)[0].command, 1100);
  EXPECT_EQ(sim.saturations(), 1);
  sim.step();
  EXPECT_EQ(sim.actuators(0)[1].command, -1100);
  EXPECT_EQ(sim.saturations(), 2);
  EXPECT_EQ(sim.actuators(0)[1].saturations, 1);
  EXPECT_EQ(sim.actuators(0)[2].saturations, 0);
}

TEST(MotorCommands, FallToWhatTheLimitsAllowNextToZero) {
  reference::MotorBody motors = motley();
  motors.actuators[0].least = 2;
  motors.actuators[0].greatest = 9;
  Bench bench = benchOf(motors, motleyStart());
  ActuatorCommand first = commandOf(0, 5, 0.1);
  first.end = 0.305;
  ActuatorCommand taken_over = commandOf(2, 0.4, 0.1);
  taken_over.end = 0.5;
  bench.world.commands = {first, taken_over, commandOf(2, 0.2, 0.2)};
  Simulation sim = bench.simulation("auto", 0.1);
  EXPECT_EQ(sim.actuators(0)[0].command, 2);
  stepTo(sim, 3);
  EXPECT_EQ(sim.actuators(0)[0].command, 5);
  stepTo(sim, 4);
  EXPECT_EQ(sim.actuators(0)[0].command, 2);
  stepTo(sim, 10);
  EXPECT_EQ(sim.actuators(0)[2].torque, 0.2);  // the later command outlives the end of the former
  EXPECT_EQ(sim.saturations(), 0);
}

TEST(MotorCommands, OfTwoThatStartTogetherTheLaterCounts) {
  Bench bench = motleyBench();
  bench.world.commands = {commandOf(0, 5, 0.1), commandOf(0, 7, 0.1)};
  Simulation sim = bench.simulation("auto", 0.1);
  stepTo(sim, 2);
  EXPECT_EQ(sim.actuators(0)[0].command, 7);
}

TEST(MotorCommands, MotorsWithoutLagFollowAtOnce) {
  reference::MotorBody motors = motley();
  std::get<Thruster>(motors.actuators[0].kind).time_constant = 0;
  Rotor& rotor = std::get<Rotor>(motors.actuators[1].kind);
  rotor.time_constant = rotor.inertia = 0;
  Simulation sim = benchOf(motors, motleyStart()).simulation("auto", 0.1);
  sim.command(commandOf(0, 5, 0));
  sim.command(commandOf(1, -20, 0));
  EXPECT_EQ(sim.actuators(0)[0].force, 5);
  EXPECT_EQ(sim.actuators(0)[1].speed, -20);
  EXPECT_EQ(sim.actuators(0)[1].force, -3e-3 * 400);
}

// However short the lag: below it, and far below the time step.
TEST(MotorCommands, ShortLagsGiveTheirImpulse) {
  for (const double T : {0.05, 1e-3, 1e-6, 1e-9}) {
    const reference::MotorBody motors{{2, Vector3d::Zero(), Matrix3d::Identity()},
                                      {named("main", thrusterAt({0, 0, 0}, {1, 0, 0}, T))},
                                      Vector3d::Zero()};
    Bench bench = benchOf(motors, BodyFrameMotion());
    bench.world.commands = {commandOf(0, 3, 0.25)};
    const double impulse = 3 * (0.75 + T * std::expm1(-0.75 / T));
    EXPECT_NEAR(bench.run("auto", 1, 10).bodies[0].p_W.x(), impulse, 1e-14) << T;
    // steps as long as the lag lets the integrator take; measured 1.7e-12
    EXPECT_NEAR(bench.run("dop853", 1, 10).bodies[0].p_W.x(), impulse, 1e-11) << T;
  }
}

TEST(MotorCommands, SetStateKeepsRelativeSpeeds) {
  Bench bench = motleyBench();
  bench.world.commands = {commandOf(2, 0.3, 0)};
  Simulation sim = bench.simulation("auto", 0.1);
  stepTo(sim, 5);
  const auto before = sim.actuators(0);
  BodyFrameMotion motion;
  motion.w_W = {-3, 2, 1};
  sim.apply(StateInput{0, motion});
  const auto after = sim.actuators(0);
  for (std::size_t k = 1; k < 4; ++k) EXPECT_NEAR(after[k].speed, before[k].speed, 1e-13) << k;
  EXPECT_EQ(after[2].torque, 0.3);
  // L = I ω with all locked, and what they have beyond
  const reference::MotorBody motors = motley();
  Vector3d L_W = motors.properties_B.I_Bcm * motion.w_W;
  const Rotor& rotor = std::get<Rotor>(motors.actuators[1].kind);
  L_W += rotor.inertia * rotor.turns * after[1].speed * rotor.direction_B;
  for (std::size_t k : {2u, 3u}) {
    const Wheel& wheel = std::get<Wheel>(motors.actuators[k].kind);
    L_W += wheel.inertia * after[k].speed * wheel.axis_B;
  }
  EXPECT_LE((sim.body(0).L_W - L_W).norm(), 1e-14);
}

TEST(MotorCommands, ResetStartsMotorsAnew) {
  Bench bench = motleyBench();
  bench.world.commands = {commandOf(0, 5, 0.1)};
  Simulation sim = bench.simulation("auto", 0.1);
  const State start = sim.state();
  stepTo(sim, 7);
  const State first = sim.state();
  sim.reset(true);
  expectSameBits(sim.state(), start);
  stepTo(sim, 7);
  expectSameBits(sim.state(), first);
  sim.reset(false);
  EXPECT_EQ(sim.actuators(0)[1].speed, 15);
  stepTo(sim, 20);
  EXPECT_EQ(sim.actuators(0)[0].force, 0);  // the scene's command was of the first start
}

TEST(MotorCommands, AStepThatFailsTakesTheirsBack) {
  Bench bench = motleyBench();
  bench.world.commands = {commandOf(0, 5, 0.55)};
  // a second body that diverges within the same step
  BodyFrameMotion motion;
  motion.x_W = {50, 0, 0};
  bench.add(principalBody("wild", 1, {1, 2, 3}), motion);
  PointWrench push = worldForce({1e308, 0, 0}, 0.52, 9);
  push.body = 1;
  bench.world.wrenches.push_back(push);
  push.force = {0, 1e308, 0};
  push.start = 0.53;
  bench.world.wrenches.push_back(push);
  Simulation sim = bench.simulation("rk4", 0.1);
  EXPECT_THROW(stepTo(sim, 100), SimulationDiverged);
  const std::int64_t steps = sim.steps();
  const double force = sim.actuators(0)[0].force;
  EXPECT_THROW(sim.step(), SimulationDiverged);
  EXPECT_EQ(sim.steps(), steps);
  EXPECT_EQ(sim.actuators(0)[0].force, force);
}

TEST(MotorCommands, BadOnesAreRefusedAndChangeNothing) {
  Simulation sim = motleyBench().simulation("auto", 0.1), untouched = sim;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refusalOf(sim, commandOf(0, nan, 0)),
            "command to 'main' of body 'body': value must be finite, got nan");
  EXPECT_EQ(refusalOf(sim, commandOf(0, 1, nan)),
            "command to 'main' of body 'body': start must be finite, got nan");
  EXPECT_EQ(refusalOf(sim, commandOf(4, 1, 0)), "body 'body': no actuator has the index 4");
  ActuatorCommand command = commandOf(0, 1, 2);
  command.end = 2;
  EXPECT_EQ(refusalOf(sim, command),
            "command to 'main' of body 'body': end must be later than its start, got 2");
  command.body = 1;
  EXPECT_EQ(refusalOf(sim, command), "no body has the index 1");
  stepTo(sim, 5);
  stepTo(untouched, 5);
  expectSameBits(sim.state(), untouched.state());
}

TEST(MotorCommands, OfThoseToComeThereAreAtMostAHundredThousand) {
  Simulation sim = motleyBench().simulation("auto", 0.1);
  for (std::size_t i = 0; i < Simulation::kMaxCommands; ++i) sim.command(commandOf(0, 1, 10));
  EXPECT_EQ(refusalOf(sim, commandOf(0, 1, 10)), "at most 100000 commands may be to come");
  stepTo(sim, 100);
  EXPECT_EQ(refusalOf(sim, commandOf(0, 1, 20)), "");
}

}  // namespace rigid_body_sim
