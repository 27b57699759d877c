#include <limits>

#include <gtest/gtest.h>

#include <rigid_body_sim/scene/resolve_wrench.hpp>

#include "scene_texts.hpp"
#include "support/refusal.hpp"

namespace rigid_body_sim {
namespace {

/// A body whose principal frame is turned and shifted against its own, at an odd pose, a second
/// one, and one that is fixed.
const char* const kScene = R"(
world_frame: map
time_step: 0.01
bodies:
  - name: box
    mass: 2
    inertia: {ixx: 3, iyy: 4, izz: 5, ixy: 0.1, ixz: -0.2, iyz: 0.3}
    center_of_mass: [0.1, -0.2, 0.3]
    position: [1, 2, 3]
    orientation: [0.1, 0.7, -0.1, 0.7]
    points:
      tip: {position: [0.5, 0.6, 0.7], orientation: [0.5, 0.5, 0.5, 0.5]}
  - {name: ball, shape: {sphere: {radius: 1}}, mass: 1, position: [5, 0, 0]}
  - name: stand
    shape: {box: [1, 2, 3]}
    mass: 1
    fixed: true
    position: [-1, 0, 0]
    orientation: [0, 0, 0.7071067811865476, 0.7071067811865476]
    points: {hook: {position: [0, 0, 1.5]}}
)";

class Frames : public testing::Test {
 protected:
  const Scene scene_ = parseScene(kScene, "s");
  const World world_ = buildWorld(scene_);
  const State state_ = initialState(scene_, world_);
  const FrameTable frames_{scene_, world_.bodies};

  /// A point given in a frame, in the world.
  Vector3d inWorld(const std::string& frame, const Vector3d& point) const {
    const FixedFrame& found = *frames_.find(frame);
    if (found.body == kWorld) return found.X_PF * point;
    const BodyState& body = state_.bodies[found.body];
    return body.x_W + body.x_low_W + rotate(body.q_WP, Vector3d(found.X_PF * point));
  }

  WrenchDef wrenchIn(const std::string& frame) const {
    WrenchDef wrench;
    wrench.body = "box";
    wrench.frame = wrench.point_frame = frame;
    wrench.point = {0.3, -0.1, 0.05};
    wrench.force = {1, 2, 12};
    wrench.torque = {0.4, 0.5, -0.6};
    wrench.duration = 2;
    return wrench;
  }

  std::string faultOf(const WrenchDef& wrench) const {
    return resolveWrench(wrench, world_.bodies, frames_).fault;
  }
};

// a handful of products of numbers below 4
constexpr double kRounding = 1e-14;

}  // namespace

TEST_F(Frames, KnowsTheWorldTheBodiesAndTheirPoints) {
  EXPECT_EQ(frames_.names(), "map, box, box/tip, ball, stand, stand/hook");
  EXPECT_EQ(frames_.find("world"), nullptr);
  EXPECT_EQ(frames_.find("tip"), nullptr);
  EXPECT_EQ(frames_.find(""), nullptr);
}

TEST_F(Frames, TurnsABodyFrameIntoThePrincipalFrame) {
  const Vector3d p(0.2, 0.4, -0.8);
  const Vector3d expected = scene_.bodies[0].position + scene_.bodies[0].orientation * p;
  EXPECT_LE((inWorld("box", p) - expected).norm(), kRounding);
}

TEST_F(Frames, TurnsAPointFrameIntoThePrincipalFrame) {
  // the orientation of the tip takes x to y, y to z and z to x
  EXPECT_LE((inWorld("box/tip", {1, 2, 3}) - inWorld("box", {3.5, 1.6, 2.7})).norm(), kRounding);
}

TEST_F(Frames, GivesTheFramesOfAFixedBodyInTheWorld) {
  EXPECT_EQ(frames_.find("stand")->body, kWorld);
  EXPECT_EQ(frames_.find("stand/hook")->body, kWorld);
  EXPECT_LE((inWorld("stand/hook", {1, 0, 0}) - Vector3d(-1, 1, 1.5)).norm(), kRounding);
}

TEST_F(Frames, CutsALongListOfNamesShort) {
  std::string text = "time_step: 1\nbodies:\n";
  for (char c = 'a'; c <= 'z'; ++c)
    text += std::string("  - {name: ") + c + ", shape: {sphere: {radius: 1}}, mass: 1}\n";
  const Scene scene = parseScene(text, "s");
  EXPECT_EQ(FrameTable(scene, buildWorld(scene).bodies).names(),
            "world, a, b, c, d, e, f, g, h, i, ...");
}

TEST_F(Frames, ResolvesAWrenchInEveryFrameToTheSameForceAndTorque) {
  // the wrench that the axes and the point themselves say, without principal frames
  const auto check = [&](const std::string& frame, std::size_t index, const Quaterniond& q_WF) {
    SCOPED_TRACE(frame);
    const WrenchDef def = wrenchIn(frame);
    const ResolvedWrench resolved = resolveWrench(def, world_.bodies, frames_);
    ASSERT_EQ(resolved.fault, "");
    EXPECT_EQ(resolved.wrench.body, 0U);
    EXPECT_EQ(resolved.wrench.axes, index);
    EXPECT_EQ(resolved.wrench.point_frame, index);
    EXPECT_EQ(resolved.wrench.start, 0);
    EXPECT_EQ(resolved.wrench.end, 2);
    Wrench sum;
    addPointWrench(resolved.wrench, state_.bodies, sum);
    const Vector3d com_W =
        inWorld("box", std::get<MassProperties>(scene_.bodies[0].composition).com_B);
    const Vector3d f_W = q_WF * def.force;
    const Vector3d tau_W = (inWorld(frame, def.point) - com_W).cross(f_W) + q_WF * def.torque;
    const Vector3d found_W = sum.tau_W + rotate(state_.bodies[0].q_WP, sum.tau_P);
    // products of arms below 7 m and forces below 13 N
    EXPECT_LE((sum.f_W - f_W).norm(), 1e-14 * 13);
    EXPECT_LE((found_W - tau_W).norm(), 1e-14 * 7 * 13);
  };
  const Quaterniond q_WB = scene_.bodies[0].orientation;
  check("map", kWorld, Quaterniond::Identity());
  check("box", 0, q_WB);
  check("box/tip", 0, q_WB * Quaterniond(0.5, 0.5, 0.5, 0.5));
  check("ball", 1, Quaterniond::Identity());
  check("stand", kWorld, scene_.bodies[2].orientation);
  check("stand/hook", kWorld, scene_.bodies[2].orientation);
}

TEST_F(Frames, TakesThePointInTheBodyUnlessStatedOtherwise) {
  WrenchDef def = wrenchIn("map");
  def.point_frame.clear();
  const PointWrench wrench = resolveWrench(def, world_.bodies, frames_).wrench;
  EXPECT_EQ(wrench.point_frame, 0U);
  EXPECT_EQ(wrench.point, frames_.find("box")->X_PF * def.point);
}

TEST_F(Frames, RefusesAWrenchThatNamesWhatIsNotThere) {
  WrenchDef wrench = wrenchIn("map");
  wrench.body = "bax";
  EXPECT_EQ(faultOf(wrench), "unknown body 'bax' (known: box, ball, stand); did you mean 'box'?");
  wrench.body = "stand";
  EXPECT_EQ(faultOf(wrench), "body 'stand' is fixed, no wrench can move it");
  wrench = wrenchIn("");
  EXPECT_EQ(faultOf(wrench),
            "unknown frame '' (known: map, box, box/tip, ball, stand, stand/hook)");
  wrench = wrenchIn("box");
  wrench.point_frame = "box/tap";
  EXPECT_EQ(
      faultOf(wrench),
      "unknown point_frame 'box/tap' (known: map, box, box/tip, ball, stand, stand/hook); did "
      "you mean 'box/tip'?");
}

TEST_F(Frames, RefusesAWrenchOfBadNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double inf = std::numeric_limits<double>::infinity();
  const auto faultWith = [&](auto change) {
    WrenchDef wrench = wrenchIn("box");
    change(wrench);
    return faultOf(wrench);
  };
  EXPECT_EQ(faultWith([&](WrenchDef& w) { w.point.y() = inf; }),
            "point must be finite, got [0.3, inf, 0.05]");
  EXPECT_EQ(faultWith([&](WrenchDef& w) { w.force.x() = nan; }),
            "force must be finite, got [nan, 2, 12]");
  EXPECT_EQ(faultWith([&](WrenchDef& w) { w.torque.z() = -inf; }),
            "torque must be finite, got [0.4, 0.5, -inf]");
  EXPECT_EQ(faultWith([&](WrenchDef& w) { w.start = nan; }),
            "start must be a finite number of s, got nan");
  EXPECT_EQ(faultWith([&](WrenchDef& w) { w.duration = -1; }), "duration must be > 0 s, got -1");
  EXPECT_EQ(faultWith([&](WrenchDef& w) { w.duration = nan; }), "duration must be > 0 s, got nan");
  EXPECT_EQ(faultWith([&](WrenchDef& w) { w.start = 1e20; }),
            "duration must be long enough to count beside start 1e+20 s, got 2");
}

TEST_F(Frames, RefusesAWrenchThatIsFiniteInItsOwnFrameOnly) {
  WrenchDef wrench = wrenchIn("box/tip");
  wrench.frame = "box";  // its principal axes are turned: components add up
  wrench.force.setConstant(1.7e308);
  EXPECT_EQ(faultOf(wrench).substr(0, 26), "force must be finite, got ");

  FrameTable table = frames_;
  Isometry3d far = Isometry3d::Identity();
  far.translation().x() = std::numeric_limits<double>::infinity();
  table.attach("far", "box", far);
  wrench = wrenchIn("far");
  EXPECT_EQ(resolveWrench(wrench, world_.bodies, table).fault.substr(0, 26),
            "point must be finite, got ");
}

TEST_F(Frames, AreAttachedToThoseThatAreThere) {
  FrameTable table = frames_;
  EXPECT_EQ(test::refusalOf([&] { table.attach("far", "bax", Isometry3d::Identity()); }),
            "frame 'far': there is no frame 'bax' that it could be attached to");
  EXPECT_EQ(table.find("far"), nullptr);
}

TEST(SceneWrench, IsRefusedWithItsLineWhenItNamesWhatIsNotThere) {
  EXPECT_EQ(errorOf(boxScene("wrenches:\n  - {body: bax, frame: box, duration: 1}\n")),
            "s.yaml:7: wrenches[0]: unknown body 'bax' (known: box); did you mean 'box'?");
  EXPECT_EQ(errorOf(boxScene("wrenches:\n  - {body: box, frame: map, duration: 1}\n")),
            "s.yaml:7: wrenches[0]: unknown frame 'map' (known: world, box)");
  EXPECT_EQ(errorOf(boxScene("wrenches:\n  - {body: \"a\\nb\", frame: map, duration: 1}\n")),
            "s.yaml:7: wrenches[0]: unknown body 'a?b' (known: box)");
}

}  // namespace rigid_body_sim
