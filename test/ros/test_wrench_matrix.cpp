#include <map>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/dynamics/simulation.hpp>
#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/inputs/wrench_intake.hpp"
#include "ros/messages/conversions.hpp"

namespace rigid_body_sim {
namespace {

Isometry3d pose(const Vector3d& position, const Quaterniond& q) {
  Isometry3d X = Isometry3d::Identity();
  X.linear() = q.toRotationMatrix();
  X.translation() = position;
  return X;
}

const Isometry3d kTip = pose({1, 0, -0.5}, {0.8, 0, 0, 0.6});              // in box
const Isometry3d kNozzle = pose({-0.2, 0.7, 0.3}, {0.5, -0.5, 0.5, 0.5});  // in box
const Isometry3d kPort = pose({0.1, 0.2, -0.3}, {0, 0.6, 0.8, 0});         // in other
const char* const kFrames[] = {"world", "box", "box/tip", "nozzle", "other", "port"};

/// Centre of mass in the body frame, and its attitude when the wrench comes.
using Placement = std::tuple<Vector3d, Quaterniond>;

Scene sceneOf(const Placement& placement) {
  Scene scene = parseScene(R"(
time_step: 0.01
bodies:
  - name: box
    mass: 2.0
    inertia: {ixx: 1.0, iyy: 1.5, izz: 2.0, ixy: 0.1, ixz: -0.2, iyz: 0.05}
    position: [1, 2, 3]
    points: {tip: {position: [1, 0, -0.5], orientation: [0, 0, 0.6, 0.8]}}
  - {name: other, shape: {box: [1, 2, 3]}, mass: 1, position: [0, 5, 0],
     orientation: [0.5, 0.5, 0.5, 0.5]}
)",
                           "test");
  std::get<MassProperties>(scene.bodies[0].composition).com_B = std::get<0>(placement);
  scene.bodies[0].orientation = std::get<1>(placement);
  return scene;
}

/// Every frame as axes and as place of a wrench on `box`, which comes when the bodies are in one
/// state and is looked at when they are in another: what belongs to a body has gone with it.
class WrenchMatrix : public ::testing::TestWithParam<Placement> {
 protected:
  WrenchMatrix() {
    tf2_msgs::TFMessage hung;
    hung.transforms.push_back(toTransform(kNozzle, "box", "nozzle", ros::Time(1)));
    hung.transforms.push_back(toTransform(kPort, "other", "port", ros::Time(1)));
    intake.addStatic(hung);
    motion["box"].x_W = Vector3d(-3, 1, 4);
    motion["box"].q_WB = Quaterniond(0.1, -0.7, 0.5, 0.5);
    motion["box"].q_WB.coeffs() /= motion["box"].q_WB.norm();
    motion["other"].x_W = Vector3d(2, 7, -1);
    motion["other"].q_WB = Quaterniond(0.6, 0, -0.8, 0);
    for (const Body& body : world.bodies) later.push_back(toBodyState(body, motion[body.name]));
  }

  /// A frame where the bodies are later.
  Isometry3d poseOf(const std::string& frame) {
    if (frame == "world") return Isometry3d::Identity();
    const std::string body = frame == "other" || frame == "port" ? "other" : "box";
    const Isometry3d X_WB = pose(motion[body].x_W, motion[body].q_WB);
    if (frame == "box/tip") return X_WB * kTip;
    if (frame == "nozzle") return X_WB * kNozzle;
    return frame == "port" ? X_WB * kPort : X_WB;
  }

  /// f and τ in the axes of a frame, f at a place of the world: what acts about the centre of mass.
  void expectWrench(const PointWrench& applied, const std::string& axes, const Vector3d& place_W) {
    Wrench wrench;
    addPointWrench(applied, later, wrench);
    const Matrix3d R = poseOf(axes).linear();
    const Vector3d com_W = poseOf("box") * std::get<0>(GetParam());
    const Vector3d torque_W = wrench.tau_W + rotate(later[0].q_WP, wrench.tau_P);
    EXPECT_LE((wrench.f_W - R * f).norm(), tolerance);
    EXPECT_LE((torque_W - (R * tau + (place_W - com_W).cross(R * f))).norm(), tolerance);
  }

  const Scene scene = sceneOf(GetParam());
  const World world = buildWorld(scene);
  WrenchIntake intake{scene, world.bodies, 0.5};
  std::map<std::string, BodyFrameMotion> motion;
  std::vector<BodyState> later;
  const Vector3d f{1, -2, 3}, tau{0.5, 0.25, -1}, point{0.7, -0.4, 0.2};
  // a few rotations of levers below 10 and forces below 4
  const double tolerance = 2e-13;
};

}  // namespace

TEST_P(WrenchMatrix, BodyTopicTakesTheFramesOfItsBodyAndTheWorld) {
  for (const std::string frame : kFrames) {
    SCOPED_TRACE(frame);
    geometry_msgs::WrenchStamped message;
    message.header.frame_id = frame;
    message.wrench.force = toVector3(f);
    message.wrench.torque = toVector3(tau);
    if (frame == "other" || frame == "port") {
      EXPECT_THROW(intake.take("box", message, 4), std::invalid_argument);
      continue;
    }
    const PointWrench taken = intake.take("box", message, 4).wrench;
    const Vector3d com_W = poseOf("box") * std::get<0>(GetParam());
    expectWrench(taken, frame, frame == "world" ? com_W : poseOf(frame).translation());
  }
}

TEST_P(WrenchMatrix, AnyAxesAreTakenAtAPointOfAnyFrame) {
  for (const std::string axes : kFrames) {
    for (const std::string point_frame : kFrames) {
      SCOPED_TRACE(axes + " at a point of " + point_frame);
      AppliedWrench message;
      message.header.frame_id = axes;
      message.body = "box";
      message.id = "a";
      message.point_frame = point_frame;
      message.point = toPoint(point);
      message.wrench.force = toVector3(f);
      message.wrench.torque = toVector3(tau);
      expectWrench(intake.take(message, TimeOrigin(), 4).wrench, axes, poseOf(point_frame) * point);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(CentreOfMassAndAttitude, WrenchMatrix,
                         ::testing::Combine(::testing::Values(Vector3d(0, 0, 0),
                                                              Vector3d(0.3, -0.2, 0.1)),
                                            ::testing::Values(Quaterniond(1, 0, 0, 0),
                                                              Quaterniond(0.5, 0.5, -0.5, 0.5))));

namespace {

/// One message on ~wrench.
struct Push {
  int step;  // that it arrives at
  const char* id;
  double x;         // [N] and [N m] along x and about y
  double start;     // [s] as ROS time; 0: the next step
  double duration;  // [s]
};

struct ImpulseCase {
  const char* name;
  double timeout;
  std::vector<Push> pushes;
  double impulse;  // [N s] and [N m s] of them all
};

void PrintTo(const ImpulseCase& c, std::ostream* out) { *out << c.name; }

class Impulses : public ::testing::TestWithParam<std::tuple<ImpulseCase, const char*>> {};

}  // namespace

TEST_P(Impulses, AreForceTimesDurationWhateverTheStep) {
  const auto& [test_case, integrator] = GetParam();
  Scene scene = parseScene(R"(
time_step: 0.01
bodies: [{name: ball, shape: {sphere: {radius: 1}}, mass: 2}]
)",
                           "test");
  scene.integrator = integrator;
  const World world = buildWorld(scene);
  WrenchIntake intake(scene, world.bodies, test_case.timeout);
  Simulation run(world, initialState(scene, world));
  while (run.steps() < 200) {
    for (const Push& push : test_case.pushes) {
      if (push.step != run.steps()) continue;
      AppliedWrench message;
      message.header.frame_id = "world";
      message.body = "ball";
      message.id = push.id;
      message.wrench.force.x = message.wrench.torque.y = push.x;
      message.start = ros::Time(push.start);
      message.duration = ros::Duration(push.duration);
      run.apply(intake.take(message, TimeOrigin(), run.time()));
    }
    run.step();
  }
  EXPECT_EQ(run.wrenchCount(), 0U);
  // instants are differences of times below 2, in 200 steps
  const double tolerance = 200 * 2 * 3 * 1.1e-16;
  EXPECT_NEAR(run.body(0).p_W.x(), test_case.impulse, tolerance);
  EXPECT_NEAR(run.body(0).L_W.y(), test_case.impulse, tolerance);
}

INSTANTIATE_TEST_SUITE_P(
    WrenchMatrix, Impulses,
    ::testing::Combine(
        ::testing::Values(
            ImpulseCase{"no multiple of the step", 0.5, {{3, "a", 3, 0, 0.0123456}}, 3 * 0.0123456},
            ImpulseCase{"shorter than a step", 0.5, {{3, "a", 3, 0, 0.0004}}, 3 * 0.0004},
            ImpulseCase{"within a step to come", 0.5, {{3, "a", 3, 0.5531, 0.0047}}, 3 * 0.0047},
            ImpulseCase{"across steps to come", 0.5, {{3, "a", 3, 0.1317, 1.2345}}, 3 * 1.2345},
            ImpulseCase{
                "start gone by, the duration whole", 0.5, {{50, "a", 3, 0.1, 0.3333}}, 0.9999},
            ImpulseCase{"ids add", 0.5, {{0, "a", 3, 0, 0.1}, {4, "b", 2, 0, 0.22}}, 0.3 + 0.44},
            ImpulseCase{"no id adds", 0.5, {{0, "", 3, 0, 0.1}, {4, "", 3, 0, 0.22}}, 0.3 + 0.66},
            ImpulseCase{"an id replaces at once",
                        0.5,
                        {{0, "a", 3, 0, 1}, {7, "a", 2, 0, 0.0333}},
                        3 * 0.07 + 2 * 0.0333},
            ImpulseCase{"an id replaces at its start",
                        0.5,
                        {{0, "a", 3, 0, 1}, {7, "a", 2, 0.1557, 0.0333}},
                        3 * 0.1557 + 2 * 0.0333},
            ImpulseCase{"zero stops", 0.5, {{0, "a", 3, 0, 0}, {13, "a", 0, 0, 0.001}}, 3 * 0.13},
            ImpulseCase{"held to the timeout", 0.5, {{3, "a", 3, 0, 0}}, 3 * 0.5},
            ImpulseCase{"a timeout of no whole steps", 0.1234, {{3, "a", 3, 0, 0}}, 3 * 0.1234},
            ImpulseCase{"held anew", 0.5, {{0, "a", 3, 0, 0}, {30, "a", 3, 0, 0}}, 3 * 0.8},
            ImpulseCase{
                "held anew too late", 0.5, {{0, "a", 3, 0, 0}, {60, "a", 3, 0, 0}}, 3 * 1.0}),
        ::testing::Values("auto", "rk4", "strang", "semi_implicit_euler", "dop853")));

}  // namespace rigid_body_sim
