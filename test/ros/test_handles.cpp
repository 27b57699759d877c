#include <gtest/gtest.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/messages/conversions.hpp"
#include "ros/mouse/handles.hpp"
#include "ros/mouse/menu.hpp"
#include "ros/outputs/arrow_markers.hpp"

namespace rigid_body_sim {
namespace {

using visualization_msgs::InteractiveMarker;
using visualization_msgs::Marker;

std::vector<InteractiveMarker> handlesOf(const std::string& bodies) {
  const Scene scene = parseScene("time_step: 0.01\nbodies: [" + bodies + "]", "test");
  return toHandles(scene, buildWorld(scene));
}

}  // namespace

TEST(Handles, HangOnEveryBodyThatMovesInItsFrame) {
  const auto handles = handlesOf(
      "{name: a, shape: {sphere: {radius: 1}}, mass: 1}, "
      "{name: b, shape: {sphere: {radius: 1}}, mass: 1, fixed: true}, "
      "{name: c, shape: {sphere: {radius: 1}}, mass: 1}");
  ASSERT_EQ(handles.size(), 2U);
  EXPECT_EQ(handles[0].name, "a");
  EXPECT_EQ(handles[1].name, "c");
  EXPECT_EQ(handles[1].header.frame_id, "c");
  EXPECT_EQ(handles[1].menu_entries.size(), menuEntries().size());
  EXPECT_TRUE(handles[1].header.stamp.isZero());  // viewers carry it along
}

TEST(Handles, AreShellsAroundWhatIsDrawn) {
  // parts at z = 0 and z = 3, the latter of twice the mass: the centre of mass at z = 2
  const auto handles = handlesOf(
      "{name: a, parts: [{shape: {box: [1, 2, 3]}, mass: 1}, "
      "{shape: {sphere: {radius: 1}}, mass: 2, position: [0, 0, 3]}]}");
  ASSERT_EQ(handles.size(), 1U);
  const std::vector<Marker>& shells = handles[0].controls.at(0).markers;
  ASSERT_EQ(shells.size(), 2U);
  EXPECT_EQ(shells[0].header.frame_id, "");
  EXPECT_LT((fromVector3(shells[0].scale) - 1.02 * Vector3d(1, 2, 3)).norm(), 1e-15);
  EXPECT_NEAR(shells[0].pose.position.z, 2 - 1.02 * 2, 1e-15);
  EXPECT_NEAR(shells[1].pose.position.z, 2 + 1.02 * 1, 1e-15);
}

TEST(Handles, AreBallsWhereNothingIsDrawn) {
  Scene scene = parseScene(
      "time_step: 0.01\nbodies: [{name: a, mass: 1, center_of_mass: [1, 2, 3],"
      "inertia: {ixx: 0.4, iyy: 0.4, izz: 0.4}}]",
      "test");
  const World world = buildWorld(scene);
  scene.bodies[0].composition = LinkDef();  // without <visual>
  const auto handles = toHandles(scene, world);
  const std::vector<Marker>& shells = handles.at(0).controls.at(0).markers;
  ASSERT_EQ(shells.size(), 1U);
  EXPECT_EQ(shells[0].type, Marker::SPHERE);
  EXPECT_NEAR(shells[0].scale.x, 1.02 * 2, 1e-15);
  EXPECT_LT((fromPoint(shells[0].pose.position) - Vector3d(1, 2, 3)).norm(), 1e-15);
}

}  // namespace rigid_body_sim
