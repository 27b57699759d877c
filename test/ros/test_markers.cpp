#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include <rigid_body_sim/scene/load_scene.hpp>

#include "ros/outputs/markers.hpp"
#include "ros/outputs/shape_markers.hpp"

namespace rigid_body_sim {
namespace {

using visualization_msgs::Marker;

Marker markerOf(const std::string& body_lines) {
  const Scene scene =
      parseScene("time_step: 0.01\nbodies: [{name: a, " + body_lines + "}]", "test");
  const auto markers = toMarkers(scene).markers;
  EXPECT_EQ(markers.size(), 1U);
  EXPECT_EQ(markers.at(0).header.frame_id, "a");
  EXPECT_TRUE(markers.at(0).frame_locked);
  return markers.at(0);
}

void expectScale(const Marker& marker, double x, double y, double z) {
  EXPECT_DOUBLE_EQ(marker.scale.x, x);
  EXPECT_DOUBLE_EQ(marker.scale.y, y);
  EXPECT_DOUBLE_EQ(marker.scale.z, z);
}

}  // namespace

TEST(Markers, DrawTheShape) {
  const Marker box = markerOf("shape: {box: [1, 2, 3]}, mass: 1");
  EXPECT_EQ(box.type, Marker::CUBE);
  expectScale(box, 1, 2, 3);
  const Marker sphere = markerOf("shape: {sphere: {radius: 2}}, mass: 1");
  EXPECT_EQ(sphere.type, Marker::SPHERE);
  expectScale(sphere, 4, 4, 4);
  const Marker cylinder = markerOf("shape: {cylinder: {radius: 2, length: 5}}, mass: 1");
  EXPECT_EQ(cylinder.type, Marker::CYLINDER);
  expectScale(cylinder, 4, 4, 5);
}

TEST(Markers, DrawCapsuleEllipsoidAndConeInTheirOwnFrames) {
  const auto capsule = shapeMarkers(Capsule{0.5, 2});
  ASSERT_EQ(capsule.size(), 3U);
  EXPECT_EQ(capsule[0].pose.position.z, -1);
  EXPECT_EQ(capsule[1].pose.position.z, 1);
  expectScale(capsule[2], 1, 1, 2);
  EXPECT_EQ(shapeMarkers(Capsule{0.5, 0}).size(), 2U);

  const auto ellipsoid = shapeMarkers(Ellipsoid{Vector3d(1, 2, 3)});
  ASSERT_EQ(ellipsoid.size(), 1U);
  EXPECT_EQ(ellipsoid[0].type, Marker::SPHERE);
  expectScale(ellipsoid[0], 2, 4, 6);

  const auto cone = shapeMarkers(Cone{2, 4});
  ASSERT_EQ(cone.size(), 1U);
  ASSERT_EQ(cone[0].points.size() % 3, 0U);
  for (const auto& point : cone[0].points) {
    // on the axis or on the rim, apex at 3/4 of the length
    const double r = std::hypot(point.x, point.y);
    EXPECT_TRUE(r == 0 || std::abs(r - 2) < 1e-14);
    EXPECT_TRUE(point.z == -1 || (point.z == 3 && r == 0));
  }
}

TEST(Markers, PlaceEveryPartInTheBodyFrame) {
  // turned by 90° about x: z becomes −y; the capsule's caps lie along it
  const auto markers = toMarkers(parseScene("time_step: 1\nbodies: [{name: a, parts: ["
                                            "{shape: {box: [1, 1, 1]}, mass: 1},"
                                            "{shape: {capsule: {radius: 1, length: 4}}, mass: 1, "
                                            "position: [5, 0, 0], orientation: "
                                            "[0.7071067811865476, 0, 0, 0.7071067811865476]}]}]",
                                            "test"))
                           .markers;
  ASSERT_EQ(markers.size(), 4U);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(markers[static_cast<std::size_t>(i)].id, i);
  EXPECT_EQ(markers[1].pose.position.x, 5);
  EXPECT_NEAR(markers[1].pose.position.y, 2, 1e-15);
  EXPECT_NEAR(markers[2].pose.position.y, -2, 1e-15);
  EXPECT_NEAR(markers[3].pose.orientation.x, std::sqrt(0.5), 1e-15);
}

TEST(Markers, DrawAMeshByItsUrlInItsOwnColoursUnlessOneIsGiven) {
  const std::string sphere = "shape: {sphere: {radius: 1}}, mass: 1, ";
  const Marker own = markerOf(sphere + "visual: {mesh: 'package://p/a.dae'}");
  EXPECT_EQ(own.type, Marker::MESH_RESOURCE);
  EXPECT_EQ(own.mesh_resource, "package://p/a.dae");
  EXPECT_TRUE(own.mesh_use_embedded_materials);
  expectScale(own, 1, 1, 1);
  const Marker given = markerOf(sphere + "visual: {mesh: '/m/a.stl', color: [1, 0, 0, 1]}");
  EXPECT_EQ(given.mesh_resource, "file:///m/a.stl");
  EXPECT_FALSE(given.mesh_use_embedded_materials);
}

TEST(Markers, HaveTheColourOfTheScene) {
  const Marker marker =
      markerOf("shape: {box: [1, 2, 3]}, mass: 1, visual: {color: [0.25, 0.5, 0.75, 1]}");
  EXPECT_EQ(marker.color.r, 0.25F);
  EXPECT_EQ(marker.color.g, 0.5F);
  EXPECT_EQ(marker.color.b, 0.75F);
  EXPECT_EQ(marker.color.a, 1.0F);
}

TEST(Markers, DrawGivenInertiaAsTheBoxThatHasIt) {
  // the box 1 x 2 x 3 m of 12 kg, its principal moments in descending order of side
  const Marker marker =
      markerOf("mass: 12, inertia: {ixx: 13, iyy: 10, izz: 5}, center_of_mass: [0.1, 0.2, 0.3]");
  EXPECT_EQ(marker.type, Marker::CUBE);
  EXPECT_NEAR(marker.scale.x * marker.scale.y * marker.scale.z, 6, 1e-12);
  EXPECT_NEAR(marker.pose.position.z, 0.3, 1e-15);
  // the longest side lies along z, the axis of the least moment
  EXPECT_NEAR(marker.scale.x, 3, 1e-12);
  const auto& q = marker.pose.orientation;
  const Vector3d longest = Quaterniond(q.w, q.x, q.y, q.z) * Vector3d::UnitX();
  EXPECT_NEAR(std::abs(longest.z()), 1, 1e-12);
}

TEST(Markers, DrawAPlaneAsASquareBelowWhatRestsOnIt) {
  const Marker patch = markerOf("shape: {plane: {}}, fixed: true");
  EXPECT_EQ(patch.type, Marker::CUBE);
  EXPECT_EQ(patch.scale.x, patch.scale.y);
  EXPECT_GT(patch.scale.x, 1);
  EXPECT_LT(patch.scale.z, 0.1);
  EXPECT_EQ(patch.pose.position.z + patch.scale.z / 2, 0);
}

}  // namespace rigid_body_sim
