#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rigid_body_sim/scene/load_scene.hpp>

#include "support/mesh_texts.hpp"
#include "support/temporary_directory.hpp"
#include "support/triangulations.hpp"

namespace rigid_body_sim {

TEST(SceneFiles, AreAllThatTheSceneNames) {
  const TemporaryDirectory files;
  const std::string cube = asciiStl(triangulated(Box{{1, 1, 1}}, 0));
  for (const char* mesh : {"solid.stl", "touch.stl", "share.stl"}) files.written(mesh, cube);
  files.written("r.urdf",
                "<robot name='r'><link name='base'><inertial><mass value='1'/><inertia ixx='1' "
                "iyy='1' izz='1' ixy='0' ixz='0' iyz='0'/></inertial><visual><geometry><mesh "
                "filename='link look.dae'/></geometry></visual><collision><geometry><mesh "
                "filename='touch.stl'/></geometry></collision></link></robot>");
  const std::string scene = files.written("s.yaml", R"(
time_step: 0.01
bodies:
  - {name: a, shape: {mesh: {file: solid.stl}}, mass: 1, visual: {mesh: look.dae}}
  - {name: b, shape: {mesh: {file: "package://p/share.stl"}}, mass: 1, position: [0, 0, 9],
     visual: {mesh: "package://p/not_looked_for.dae"}}
  - {name: c, urdf: {file: ./r.urdf}, position: [0, 9, 9]}
)");
  const auto named = [&](const std::string& path) {
    const std::string directory = files.path("");
    return loadScene(path,
                     [&](const std::string&) { return directory.substr(0, directory.size() - 1); })
        .files;
  };
  std::vector<std::string> expected = {files.path("link look.dae"), files.path("look.dae"),
                                       files.path("r.urdf"), files.path("share.stl"),
                                       files.path("solid.stl")};
  EXPECT_EQ(named(scene), expected);
  // that of the link is read where it touches
  files.written("s.yaml", R"(
time_step: 0.01
bodies: [{name: c, urdf: {file: ./r.urdf}}, {name: d, shape: {sphere: {radius: 1}}, mass: 1,
          position: [0, 0, 9]}]
forces: [{type: contact, between: [c, d], stiffness: 1e4}]
)");
  expected = {files.path("link look.dae"), files.path("r.urdf"), files.path("touch.stl")};
  EXPECT_EQ(named(scene), expected);
}

}  // namespace rigid_body_sim
