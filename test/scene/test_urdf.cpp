#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rigid_body_sim/scene/load_scene.hpp>

#include "scene/build/body_mass.hpp"
#include "scene/build/visuals_of.hpp"
#include "scene/urdf/read_urdf.hpp"
#include "support/mass_difference.hpp"
#include "support/temporary_directory.hpp"

namespace rigid_body_sim {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const std::string kInertial =
    "<inertial><origin xyz='0.1 -0.2 0.3' rpy='0.4 -0.5 0.6'/><mass value='2'/>"
    "<inertia ixx='3' ixy='0.1' ixz='-0.2' iyy='4' iyz='0.3' izz='5'/></inertial>";

std::string robot(const std::string& links) { return "<robot name='r'>" + links + "</robot>"; }

/// A link "base" with the given elements.
std::string base(const std::string& elements) {
  return robot("<link name='base'>" + elements + "</link>");
}

class Urdf : public ::testing::Test {
 protected:
  std::string scene(const std::string& urdf) const {
    return files_.written("s.yaml",
                          "time_step: 0.01\nbodies:\n  - name: a\n    urdf: " + urdf + "\n");
  }

  BodyDef bodyOf(const std::string& xml) const {
    files_.written("r.urdf", xml);
    return loadScene(scene("{file: r.urdf, link: base}")).bodies[0];
  }

  std::string error(const std::string& urdf) const {
    const std::string path = scene(urdf);
    try {
      loadScene(path);
    } catch (const SceneError& e) {
      const std::string line = e.what();
      EXPECT_THAT(line, StartsWith(path + ":4: body 'a': "));
      EXPECT_THAT(line, Not(HasSubstr("\n")));
      return line.substr(path.size() + 14);
    }
    return "loaded";
  }

  TemporaryDirectory files_;
};

}  // namespace

TEST_F(Urdf, GivesTheInertiaOfItsTiltedAxes) {
  // URDF: fixed axes, roll about x, then pitch about y, then yaw about z
  const Matrix3d R =
      (Eigen::AngleAxisd(0.6, Vector3d::UnitZ()) * Eigen::AngleAxisd(-0.5, Vector3d::UnitY()) *
       Eigen::AngleAxisd(0.4, Vector3d::UnitX()))
          .toRotationMatrix();
  Matrix3d I;
  I << 3, 0.1, -0.2,  //
      0.1, 4, 0.3,    //
      -0.2, 0.3, 5;
  EXPECT_TRUE(sameMass(massProperties(bodyOf(base(kInertial))),
                       {2, Vector3d(0.1, -0.2, 0.3), R * I * R.transpose()}, 1e-15));
}

TEST_F(Urdf, DrawsItsVisuals) {
  const BodyDef body = bodyOf(base(
      kInertial +
      "<visual><origin xyz='1 2 3' rpy='0 0 1.5707963267948966'/>"
      "<geometry><box size='1 2 3'/></geometry>"
      "<material name='m'><color rgba='1 0.5 0.25 1'/></material></visual>"
      "<visual><geometry><sphere radius='2'/></geometry></visual>"
      "<visual><geometry><cylinder radius='2' length='5'/></geometry></visual>"
      "<visual><geometry><mesh filename='package://p/a.dae' scale='1 2 3'/></geometry></visual>"
      "<visual><geometry><mesh filename='m/a b.stl'/></geometry></visual>"));
  const std::vector<Visual> visuals = visualsOf(body);
  ASSERT_EQ(visuals.size(), 5U);
  EXPECT_EQ(std::get<Box>(std::get<Shape>(visuals[0].geometry)).size, Vector3d(1, 2, 3));
  EXPECT_EQ(visuals[0].X_BV.translation(), Vector3d(1, 2, 3));
  EXPECT_LE((visuals[0].X_BV.linear().col(0) - Vector3d::UnitY()).norm(), 1e-15);
  EXPECT_EQ(visuals[0].color, (Color{1, 0.5, 0.25, 1}));
  EXPECT_EQ(std::get<Sphere>(std::get<Shape>(visuals[1].geometry)).radius, 2);
  EXPECT_FALSE(visuals[1].color);
  EXPECT_EQ(std::get<Cylinder>(std::get<Shape>(visuals[2].geometry)).length, 5);
  EXPECT_EQ(std::get<MeshVisual>(visuals[3].geometry).url, "package://p/a.dae");
  EXPECT_EQ(std::get<MeshVisual>(visuals[3].geometry).scale, Vector3d(1, 2, 3));
  EXPECT_EQ(std::get<MeshVisual>(visuals[4].geometry).url, "file://" + files_.path("m/a%20b.stl"));
}

TEST_F(Urdf, DrawsNothingOfALinkWithoutVisuals) {
  EXPECT_TRUE(visualsOf(bodyOf(base(kInertial))).empty());
}

TEST_F(Urdf, NamesAreThoseOfTheFile) {
  const std::string path =
      files_.written("r.urdf", robot("<link name='base'>" + kInertial +
                                     "</link><link name='arm'/><joint name='j' type='fixed'>"
                                     "<parent link='base'/><child link='arm'/></joint>"));
  const std::vector<UrdfLink> links = readUrdf(path).links;
  ASSERT_EQ(links.size(), 2U);
  EXPECT_EQ(links[0].name, "arm");
  EXPECT_FALSE(links[0].mass);
  EXPECT_EQ(links[1].name, "base");
  EXPECT_TRUE(links[1].mass);

  EXPECT_EQ(error("{file: r.urdf, link: hand}"),
            "urdf.link must be a link of " + path + " (links: arm, base), got hand");
  EXPECT_EQ(error("{file: r.urdf, link: arm}"),
            "urdf.link must have an <inertial> in " + path + ", got arm");
}

TEST_F(Urdf, KeepsTheRulesOfItsKeys) {
  EXPECT_EQ(error("{link: base}"), "missing key 'urdf.file'");
  EXPECT_EQ(error("{file: r.urdf, link: ''}"), "urdf.link must be a text, got \"\"");
  EXPECT_EQ(error("{file: r.urdf, link: base, joint: j}"),
            "unknown key 'urdf.joint' (known: file, link, fixed_joints)");
  EXPECT_EQ(error("r.urdf"), "urdf must be a mapping, got r.urdf (keys: file, link, fixed_joints)");
}

TEST_F(Urdf, SaysWhatIsWrongWithItsFile) {
  EXPECT_EQ(
      error("{file: no.urdf, link: base}"),
      "urdf.file: " + files_.path("no.urdf") + ": cannot be opened: No such file or directory");
  std::filesystem::create_directory(files_.path("d.urdf"));
  EXPECT_EQ(error("{file: d.urdf, link: base}"),
            "urdf.file: " + files_.path("d.urdf") + ": is a directory, not a URDF file");

  for (const std::string& wrong :
       {std::string("not xml"), std::string(""), std::string("<robot"), std::string("<sdf/>"),
        std::string("\0\x01\xff", 3), std::string("<robot name='r'/>"), robot("<link/>"),
        base("<inertial><mass value='heavy'/></inertial>"),
        base("<inertial><mass value='1'/></inertial>"),
        base("<inertial><origin xyz='a b c'/><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' "
             "iyy='1' iyz='0' izz='1'/></inertial>")}) {
    const std::string path = files_.written("wrong.urdf", wrong);
    EXPECT_THAT(error("{file: wrong.urdf, link: base}"),
                StartsWith("urdf.file: " + path + ": is not a URDF file that can be read: "))
        << wrong;
  }
}

TEST_F(Urdf, RefusesInertiaThatNoBodyHas) {
  const auto inertia = [](const std::string& mass, const std::string& izz) {
    return base("<inertial><mass value='" + mass +
                "'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='" + izz +
                "'/></inertial>");
  };
  files_.written("r.urdf", inertia("0", "1"));
  EXPECT_EQ(error("{file: r.urdf, link: base}"), "mass must be > 0 kg, got 0");
  files_.written("r.urdf", inertia("1", "5"));
  EXPECT_THAT(error("{file: r.urdf, link: base}"),
              StartsWith("inertia must satisfy the triangle inequality"));
}

TEST_F(Urdf, IsReadOrRefusedWhereverItEnds) {
  const std::string whole = base(kInertial +
                                 "<visual><geometry><box size='1 2 3'/></geometry>"
                                 "<material name='m'><color rgba='1 0 0 1'/>"
                                 "</material></visual>");
  for (std::size_t length = 0; length < whole.size(); length += 7) {
    const std::string path = files_.written("cut.urdf", whole.substr(0, length));
    EXPECT_THROW(readUrdf(path), std::runtime_error) << length;
  }
}

}  // namespace rigid_body_sim
