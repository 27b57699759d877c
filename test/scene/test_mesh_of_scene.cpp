#include <cstring>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rigid_body_sim/mass/checked_mesh.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "scene/build/body_mass.hpp"
#include "scene/meshes/read_mesh.hpp"
#include "support/mass_difference.hpp"
#include "support/mesh_edits.hpp"
#include "support/mesh_texts.hpp"
#include "support/temporary_directory.hpp"
#include "support/triangulations.hpp"

namespace rigid_body_sim {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// A brick off the origin with corners that single precision holds exactly.
TriangleMesh farBrick() { return translated({2, 0.5, -1}, triangulated(Box{{1, 2, 0.5}}, 0)); }

MassProperties brickOf(double mass, double scale) {
  return {mass, scale * Vector3d(2, 0.5, -1),
          massProperties(Box{scale * Vector3d(1, 2, 0.5)}, mass).I_Bcm};
}

/// A directory of mesh files with a scene beside it.
class MeshOfScene : public ::testing::Test {
 protected:
  /// The scene of one body with the given entry on lines 4 and 5, in the directory "scenes".
  std::string scene(const std::string& mesh, const std::string& matter = "mass: 3") const {
    return files_.written("scenes/s.yaml",
                          "time_step: 0.01\nbodies:\n  - name: a\n    shape: {mesh: " + mesh +
                              "}\n    " + matter + "\n");
  }

  MassProperties massOf(const std::string& mesh, const std::string& matter = "mass: 3") const {
    return massProperties(loadScene(scene(mesh, matter), finder()).bodies[0]);
  }

  /// What loading says, without the scene file's own path before the line.
  std::string error(const std::string& mesh) const {
    const std::string path = scene(mesh);
    try {
      loadScene(path, finder());
    } catch (const SceneError& e) {
      const std::string line = e.what();
      EXPECT_THAT(line, StartsWith(path + ":"));
      EXPECT_THAT(line, Not(HasSubstr("\n")));
      return line.substr(path.size());
    }
    return "loaded";
  }

  PackageFinder finder() const {
    return [this](const std::string& package) {
      return package == "bricks" ? files_.path("somewhere") : "";
    };
  }

  TemporaryDirectory files_;
};

/// A turned cube of 1 m × 1 m × 1.1 m each of whose triangles was rounded on its own way.
TriangleMesh rounded() {
  Isometry3d X = Isometry3d::Identity();
  X.linear() = Eigen::AngleAxisd(0.3, Vector3d::UnitZ()).toRotationMatrix();
  TriangleMesh loose = soup(transformed(X, triangulated(Box{{1, 1, 1.1}}, 0)));
  for (std::size_t i = 0; i < loose.vertices.size(); ++i)
    loose.vertices[i][static_cast<int>(i % 3)] += (static_cast<double>(i % 4) - 1.5) * 6e-8;
  return loose;
}

std::string objOf(const TriangleMesh& mesh, int digits) {
  std::ostringstream text;
  text.precision(digits);
  for (const Vector3d& v : mesh.vertices)
    text << "v " << v.x() << " " << v.y() << " " << v.z() << "\n";
  for (const Triangle& t : mesh.triangles)
    text << "f " << t[0] + 1 << " " << t[1] + 1 << " " << t[2] + 1 << "\n";
  return text.str();
}

const std::string kAtMesh = ":4: body 'a': shape.mesh";

}  // namespace

TEST_F(MeshOfScene, HasTheMassAndPlaceOfItsSolid) {
  files_.written("scenes/brick.stl", binaryStl(farBrick()));
  // the integrals of twelve triangles, a few ulp
  EXPECT_TRUE(sameMass(massOf("{file: brick.stl}"), brickOf(3, 1), 1e-15));
  EXPECT_TRUE(sameMass(massOf("{file: brick.stl}", "density: 3"), brickOf(3, 1), 1e-15));
  EXPECT_TRUE(
      sameMass(massOf("{file: brick.stl, scale: 0.5}", "density: 8"), brickOf(1, 0.5), 1e-15));
}

TEST_F(MeshOfScene, IsWhatTheMassLayerSays) {
  const std::string file =
      files_.written("scenes/cone.stl", asciiStl(triangulated(Cone{1, 2}, 24)));
  const TriangleMesh mesh = checkedMesh(readMesh(file, Vector3d::Constant(0.1)).mesh).mesh;
  EXPECT_TRUE(sameMass(massOf("{file: cone.stl, scale: 0.1}", "density: 7"),
                       massProperties(mesh, 7 * volume(mesh)), 1e-15));
}

TEST_F(MeshOfScene, IsFoundBesideTheSceneByAbsolutePathAndInAPackage) {
  files_.written("meshes/brick.obj", obj(farBrick()));
  files_.written("somewhere/meshes/brick.obj", obj(scaled(2, farBrick())));
  EXPECT_TRUE(sameMass(massOf("{file: ../meshes/brick.obj}"), brickOf(3, 1), 1e-15));
  EXPECT_TRUE(
      sameMass(massOf("{file: " + files_.path("meshes/brick.obj") + "}"), brickOf(3, 1), 1e-15));
  EXPECT_TRUE(
      sameMass(massOf("{file: 'package://bricks/meshes/brick.obj'}"), brickOf(3, 2), 1e-15));
}

TEST_F(MeshOfScene, IsLookedForFromTheWorkingDirectoryInASceneOfText) {
  const std::string text =
      "time_step: 1\nbodies: [{name: a, mass: 1, shape: {mesh: {file: no/such.stl}}}]\n";
  const std::string expected = "s:2: body 'a': shape.mesh.file: " +
                               (std::filesystem::current_path() / "no/such.stl").string() +
                               ": mesh file does not exist";
  try {
    parseScene(text, "s");
    FAIL();
  } catch (const SceneError& e) {
    EXPECT_EQ(e.what(), expected);
  }
}

TEST_F(MeshOfScene, SaysWhatIsWrongWithAReference) {
  const std::string rule = " must be package://<package>/<path> or a path, got ";
  for (const std::string reference : {"package://", "package://bricks", "package://bricks/",
                                      "package:///brick.stl", "http://bricks/brick.stl"})
    EXPECT_EQ(error("{file: '" + reference + "'}"),
              kAtMesh + ".file" + rule + "\"" + reference + "\"");
  EXPECT_EQ(error("{file: 'package://unknown/brick.stl'}"),
            kAtMesh +
                ".file must name a ROS package that is on ROS_PACKAGE_PATH, got "
                "\"package://unknown/brick.stl\"");
  try {
    loadScene(scene("{file: 'package://bricks/brick.stl'}"));
    FAIL();
  } catch (const SceneError& e) {
    EXPECT_THAT(e.what(), HasSubstr("shape.mesh.file must be a path: this program cannot look up "
                                    "ROS packages, got \"package://bricks/brick.stl\""));
  }
}

TEST_F(MeshOfScene, KeepsTheRulesOfItsKeys) {
  files_.written("scenes/brick.stl", binaryStl(farBrick()));
  EXPECT_EQ(error("{scale: 1}"), ":4: body 'a': missing key 'shape.mesh.file'");
  EXPECT_EQ(error("{file: [1]}"), kAtMesh + ".file must be a text, got [1]");
  EXPECT_EQ(error("{file: brick.stl, scale: 0}"), kAtMesh + ".scale must be > 0, got 0");
  EXPECT_EQ(error("{file: brick.stl, scale: -1}"), kAtMesh + ".scale must be > 0, got -1");
  EXPECT_EQ(error("{file: brick.stl, unit: mm}"),
            ":4: body 'a': unknown key 'shape.mesh.unit' (known: file, scale, solid)");
  EXPECT_EQ(error("brick.stl"),
            kAtMesh + " must be a mapping, got brick.stl (keys: file, scale, solid)");
}

TEST_F(MeshOfScene, MayBeScaledAxisByAxisAndMirrored) {
  files_.written("scenes/brick.stl", binaryStl(farBrick()));
  const Vector3d scale(-2, 0.5, 3);
  const MassProperties expected{3, scale.cwiseProduct(Vector3d(2, 0.5, -1)),
                                massProperties(Box{Vector3d(2, 1, 1.5)}, 3).I_Bcm};
  const Scene scaled = loadScene(scene("{file: brick.stl, scale: [-2, 0.5, 3]}"));
  EXPECT_TRUE(sameMass(massProperties(scaled.bodies[0]), expected, 1e-14));
  EXPECT_TRUE(scaled.notices.empty());
  EXPECT_EQ(error("{file: brick.stl, scale: [1, 0, 1]}"),
            kAtMesh + ".scale must be > 0 or three numbers other than 0, got [1, 0, 1]");
  EXPECT_EQ(error("{file: brick.stl, scale: [1, 1]}"),
            kAtMesh + ".scale must be a list of 3 numbers, got [1, 1]");
}

TEST_F(MeshOfScene, MayBeTheHullOrTheBoxOfAnOpenOne) {
  TriangleMesh open = farBrick();
  open.triangles.resize(9);  // the vertices are all in use
  const std::string path = files_.written("scenes/open.stl", binaryStl(open));
  for (const auto& [solid, name] :
       {std::pair{"hull", "convex hull"}, std::pair{"box", "oriented bounding box"}}) {
    const std::string entry = std::string("{file: open.stl, solid: ") + solid + "}";
    EXPECT_TRUE(sameMass(massOf(entry), brickOf(3, 1), 1e-14));
    EXPECT_TRUE(sameMass(massOf(entry, "density: 3"), brickOf(3, 1), 1e-14));
    const Scene loaded = loadScene(scene(entry));
    ASSERT_EQ(loaded.notices.size(), 1U);
    EXPECT_EQ(loaded.notices[0], files_.path("scenes/s.yaml") + kAtMesh + ".file: " + path +
                                     ": solid is the " + name +
                                     " of the mesh, of 1 m^3, in place of its surface");
  }
  EXPECT_EQ(error("{file: open.stl, solid: shell}"),
            kAtMesh + ".solid must be surface, hull or box, got shell");
}

TEST_F(MeshOfScene, SaysWhatToDoAboutAnOpenOne) {
  TriangleMesh open = farBrick();
  open.triangles.pop_back();
  files_.written("scenes/open.stl", binaryStl(open));
  for (const char* entry : {"{file: open.stl}", "{file: open.stl, solid: surface}"}) {
    EXPECT_THAT(error(entry),
                HasSubstr(": mesh must be closed, got 3 open edges, the first from "));
    EXPECT_THAT(error(entry), HasSubstr("shape: {mesh: {file:, solid: hull}} or solid: box"));
  }
}

TEST_F(MeshOfScene, HasNoHullWhereItIsFlat) {
  files_.written("scenes/flat.obj", "v 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 2 3\n");
  for (const char* solid : {"hull", "box"})
    EXPECT_THAT(
        error(std::string("{file: flat.obj, solid: ") + solid + "}"),
        HasSubstr("flat.obj: convex hull must enclose a volume, but all vertices lie in one "
                  "plane, to within "));
}

TEST_F(MeshOfScene, IsClosedWhereItsCornersDifferByTheRoundingOfItsNumbers) {
  const MassProperties expected{3, Vector3d::Zero(), massProperties(Box{{1, 1, 1.1}}, 3).I_Bcm};
  files_.written("scenes/binary.stl", binaryStl(rounded()));
  files_.written("scenes/seven.obj", objOf(rounded(), 7));
  files_.written("scenes/nine.obj", objOf(rounded(), 9));
  for (const std::string name : {"binary.stl", "seven.obj", "nine.obj"}) {
    const Scene loaded = loadScene(scene("{file: " + name + "}"));
    MassProperties mass = massProperties(loaded.bodies[0]);
    EXPECT_LT(mass.com_B.norm(), 1e-6) << name;
    mass.com_B.setZero();
    EXPECT_TRUE(sameMass(mass, expected, 1e-6)) << name;
    ASSERT_EQ(loaded.notices.size(), 1U) << name;
    EXPECT_THAT(loaded.notices[0], HasSubstr(" are welded to others at most "));
  }
  // of sixteen digits none of which is rounding
  files_.written("scenes/exact.obj", objOf(rounded(), 16));
  EXPECT_THAT(error("{file: exact.obj}"), HasSubstr("mesh must be closed"));
}

TEST_F(MeshOfScene, SaysWhatIsWrongWithAFile) {
  const auto fileError = [this](const std::string& name, const std::string& content) {
    const std::string path = files_.written("scenes/" + name, content);
    const std::string line = error("{file: " + name + "}");
    const std::string start = kAtMesh + ".file: " + path + ": ";
    EXPECT_THAT(line, StartsWith(start));
    return line.substr(std::min(start.size(), line.size()));
  };
  const std::string whole = binaryStl(farBrick());
  std::string claim = whole;
  const std::uint32_t claimed = 43000000;  // 2 GB
  std::memcpy(&claim[80], &claimed, 4);
  std::string with_nan = asciiStl(farBrick());
  with_nan.replace(with_nan.find("1.5"), 3, "nan");
  TriangleMesh open = farBrick();
  open.triangles.pop_back();

  EXPECT_EQ(fileError("cut.stl", whole.substr(0, 447)),
            "binary STL is truncated: its header claims 12 triangles, 684 bytes, got 447 bytes");
  EXPECT_EQ(fileError("claim.stl", claim),
            "binary STL is truncated: its header claims 43000000 triangles, 2150000084 bytes, got "
            "684 bytes");
  EXPECT_THAT(fileError("nan.stl", with_nan), StartsWith("mesh "));
  EXPECT_THAT(fileError("none.stl", binaryStl({})), StartsWith("mesh "));
  EXPECT_THAT(fileError("open.stl", binaryStl(open)), StartsWith("mesh must be closed"));
  EXPECT_EQ(fileError("brick.txt", whole), "mesh file must end in .stl, .obj or .dae, got '.txt'");

  std::filesystem::create_directory(files_.path("scenes/directory.stl"));
  EXPECT_EQ(error("{file: directory.stl}"), kAtMesh +
                                                ".file: " + files_.path("scenes/directory.stl") +
                                                ": mesh file must be a regular file");
}

TEST_F(MeshOfScene, TellsThatItWasTurnedAround) {
  const std::string path = files_.written("scenes/inward.stl", binaryStl(insideOut(farBrick())));
  const Scene turned = loadScene(scene("{file: inward.stl}"));
  ASSERT_EQ(turned.notices.size(), 1U);
  EXPECT_EQ(turned.notices[0], files_.path("scenes/s.yaml") + kAtMesh + ".file: " + path +
                                   ": mesh is oriented inwards (volume -1 m^3): its 12 triangles "
                                   "are turned around");
  EXPECT_TRUE(sameMass(massProperties(turned.bodies[0]), brickOf(3, 1), 1e-15));
}

TEST_F(MeshOfScene, IsReadOnceForAllItsBodies) {
  files_.written("scenes/inward.stl", binaryStl(insideOut(farBrick())));
  const std::string entry = ", mass: 1, shape: {mesh: {file: inward.stl}}}";
  const Scene scene = loadScene(files_.written(
      "scenes/two.yaml", "time_step: 1\nbodies: [{name: a" + entry + ", {name: b" + entry + "]\n"));
  EXPECT_EQ(scene.notices.size(), 1U);
  const auto volume_of = [&](std::size_t i) {
    return volumeOf(std::get<SolidDef>(scene.bodies[i].composition).geometry);
  };
  EXPECT_EQ(volume_of(0), volume_of(1));
}

}  // namespace rigid_body_sim
