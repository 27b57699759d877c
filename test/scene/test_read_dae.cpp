#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <rigid_body_sim/mass/checked_mesh.hpp>

#include "scene/meshes/read_dae.hpp"
#include "support/mass_difference.hpp"
#include "support/mesh_edits.hpp"
#include "support/mesh_texts.hpp"
#include "support/triangulations.hpp"

namespace rigid_body_sim {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Corners of a cube of edge 1, from 0 to 1: x fastest.
const std::string kUnitCorners = "0 0 0 1 0 0 0 1 0 1 1 0 0 0 1 1 0 1 0 1 1 1 1 1";
const std::string kQuads = "0 2 3 1 4 5 7 6 0 1 5 4 2 6 7 3 0 4 6 2 1 3 7 5";
const std::string kPolylist =
    "<polylist count=\"6\"><input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>"
    "<vcount>4 4 4 4 4 4</vcount><p>" +
    kQuads + "</p></polylist>";
const std::string kNode = "<node id=\"n\"><instance_geometry url=\"#g\"/></node>";

/// A file of one geometry: its positions, its primitives, what the scene holds, and nodes beside
/// it.
std::string file(const std::string& primitives, const std::string& scene = kNode,
                 const std::string& nodes = "", const std::string& positions = kUnitCorners) {
  return "<COLLADA><library_geometries><geometry id=\"g\"><mesh>\n"
         "<source id=\"p\"><float_array id=\"a\" count=\"24\">" +
         positions +
         "</float_array><technique_common>"
         "<accessor source=\"#a\" count=\"8\" stride=\"3\"><param name=\"X\"/><param name=\"Y\"/>"
         "<param name=\"Z\"/></accessor></technique_common></source>\n"
         "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices>\n" +
         primitives + "\n</mesh></geometry></library_geometries>\n<library_nodes>" + nodes +
         "</library_nodes>\n<library_visual_scenes><visual_scene id=\"s\">" + scene +
         "</visual_scene></library_visual_scenes>\n"
         "<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>\n";
}

/// The mesh of a file that is closed and oriented outwards as it is.
TriangleMesh solidIn(const std::string& text) {
  const FileMesh read = readDae(text);
  const CheckedMesh checked = checkedMesh(read.mesh);
  EXPECT_EQ(checked.fault, "");
  EXPECT_THAT(checked.notices, IsEmpty());
  return checked.mesh;
}

std::string refusal(const std::string& text) {
  try {
    readDae(text);
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "read";
}

const std::string kRefused = "mesh file cannot be read: ";

}  // namespace

TEST(ReadDae, KeepsEveryDigit) {
  const std::string tenths =
      "0 0 0 0.1 0 0 0 0.1 0 0.1 0.1 0 0 0 0.1 0.1 0 0.1 0 0.1 0.1 0.1 0.1 0.1";
  EXPECT_DOUBLE_EQ(volume(solidIn(file(kPolylist, kNode, "", tenths))), 0.001);
}

TEST(ReadDae, ReadsEveryKindOfPrimitiveThatHasTriangles) {
  const std::string input = "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>";
  const std::string polygons = "<polygons>" + input +
                               "<p>0 2 3 1</p><p>4 5 7 6</p><p>0 1 5 4</p><p>2 6 7 3</p>"
                               "<p>0 4 6 2</p><p>1 3 7 5</p></polygons>";
  const std::string fans =
      "<trifans>" + input + "<p>0 2 3 1 5 4 6 2</p><p>7 6 4 5 1 3 2 6</p></trifans>";
  const std::string strips = "<tristrips>" + input +
                             "<p>0 2 1 3 5 7 4 6</p><p>1 5 0 4</p><p>0 4 2 6</p>"
                             "<p>2 6 3 7</p></tristrips>";
  const std::string lines = "<lines count=\"1\">" + input + "<p>0 7</p></lines>";
  const std::string triangles =
      "<triangles count=\"12\">" + input +
      "<p>0 2 3 0 3 1 4 5 7 4 7 6 0 1 5 0 5 4 2 6 7 2 7 3 0 4 6 0 6 2 1 3 7 1 7 5</p></triangles>";
  for (const std::string& primitives : {kPolylist, polygons, fans, strips, triangles}) {
    const TriangleMesh mesh = solidIn(file(lines + primitives));
    EXPECT_EQ(mesh.triangles.size(), 12u) << primitives;
    EXPECT_DOUBLE_EQ(volume(mesh), 1) << primitives;
  }
}

TEST(ReadDae, TakesTheIndexOfTheVertexAmongThoseOfOtherInputs) {
  std::string indices;
  for (const char c : kQuads)
    indices += c == ' ' ? std::string(" ") : "9 " + std::string(1, c) + " 7";
  const std::string polylist =
      "<polylist count=\"6\"><input semantic=\"NORMAL\" source=\"#none\" offset=\"0\"/>"
      "<input semantic=\"VERTEX\" source=\"#v\" offset=\"1\"/>"
      "<input semantic=\"TEXCOORD\" source=\"#none\" offset=\"2\"/>"
      "<vcount>4 4 4 4 4 4</vcount><p>" +
      indices + "</p></polylist>";
  EXPECT_DOUBLE_EQ(volume(solidIn(file(polylist))), 1);
}

TEST(ReadDae, AppliesTheTransformsOfNodesInTheirOrder) {
  const std::string moved =
      "<node><translate>1 0 0</translate><rotate>0 0 2 90</rotate><scale>2 1 1</scale>"
      "<node><matrix>1 0 0 0.5 0 1 0 0 0 0 1 0 0 0 0 1</matrix>"
      "<instance_geometry url=\"#g\"/></node></node>";
  const TriangleMesh mesh = solidIn(file(kPolylist, moved));
  // x from 0.5 to 1.5, doubled, then turned to y; y to −x
  EXPECT_DOUBLE_EQ(volume(mesh), 2);
  EXPECT_TRUE(massProperties(mesh, 1).com_B.isApprox(Vector3d(0.5, 2, 0.5), 1e-15));
}

TEST(ReadDae, KeepsTheOutsideOfAMirroredNodeOutside) {
  const std::string mirrored = "<node><scale>-1 1 1</scale><instance_geometry url=\"#g\"/></node>";
  EXPECT_DOUBLE_EQ(volume(solidIn(file(kPolylist, mirrored))), 1);
}

TEST(ReadDae, ExpandsInstancesOfNodes) {
  const std::string scene =
      "<node><translate>0 0 2</translate><instance_node url=\"#pair\"/></node>"
      "<node><translate>0 5 0</translate><instance_node url=\"#pair\"/></node>";
  const std::string nodes =
      "<node id=\"pair\"><instance_node url=\"#one\"/><node><translate>3 0 0</translate>"
      "<instance_node url=\"#one\"/></node></node>"
      "<node id=\"one\"><instance_geometry url=\"#g\"/></node>";
  const TriangleMesh mesh = solidIn(file(kPolylist, scene, nodes));
  EXPECT_EQ(mesh.triangles.size(), 48u);
  EXPECT_DOUBLE_EQ(volume(mesh), 4);
  EXPECT_TRUE(massProperties(mesh, 4).com_B.isApprox(Vector3d(2, 3, 1.5), 1e-15));
}

TEST(ReadDae, LooksFromAPlaceTowardsAnother) {
  // to x with z up: the node's own x to the right of that, -y, its y upwards, its z backwards
  const std::string scene =
      "<node><lookat>1 2 3 6 2 3 0 0 1</lookat><scale>1 2 3</scale>"
      "<instance_geometry url=\"#g\"/></node>";
  const TriangleMesh mesh = solidIn(file(kPolylist, scene));
  EXPECT_DOUBLE_EQ(volume(mesh), 6);
  EXPECT_TRUE(massProperties(mesh, 6).com_B.isApprox(Vector3d(1 - 1.5, 2 - 0.5, 3 + 1), 1e-15));
}

TEST(ReadDae, LooksUpwardsAsFarAsWhereItLooksAllows) {
  // Eye (0, 0, 5), seen the origin, so that the node's z is back at the eye, upwards: (0, 0, 1). Up
  // (0, 3, 4) leans along that; square to it is (0, 1, 0), the node's y. Its x is y × z = (1, 0,
  // 0).
  const std::string upright =
      "<node><lookat>0 0 5 0 0 0 0 3 4</lookat><instance_geometry url=\"#g\"/></node>";
  const TriangleMesh mesh = solidIn(file(kPolylist, upright));
  EXPECT_DOUBLE_EQ(volume(mesh), 1);
  EXPECT_TRUE(massProperties(mesh, 1).com_B.isApprox(Vector3d(0.5, 0.5, 5.5), 1e-15));

  // Eye (1, 2, 3), seen the origin: z = (1, 2, 3)/√14. Up (0, 0, 1) less its part along z is
  // (0, 0, 1) - 3/14 (1, 2, 3) = (-3, -6, 5)/14, of length √(70)/14: y = (-3, -6, 5)/√70. x = y × z
  // = (-28, 14, 0)/√(980) = (-2, 1, 0)/√5. The centre of the cube, (½, ½, ½) of the node, is there:
  const Vector3d center = Vector3d(1, 2, 3) + 0.5 * (Vector3d(-2, 1, 0) / std::sqrt(5) +
                                                     Vector3d(-3, -6, 5) / std::sqrt(70) +
                                                     Vector3d(1, 2, 3) / std::sqrt(14));
  for (const char* numbers : {"1 2 3 0 0 0 0 0 1", "1 2 3 -1e200 -2e200 -3e200 0 0 1e-200"}) {
    const std::string scene =
        std::string("<node><lookat>") + numbers + "</lookat><instance_geometry url=\"#g\"/></node>";
    const TriangleMesh leaning = solidIn(file(kPolylist, scene));
    EXPECT_NEAR(volume(leaning), 1, 1e-14) << numbers;
    EXPECT_TRUE(massProperties(leaning, 1).com_B.isApprox(center, 1e-14)) << numbers;
  }
}

TEST(ReadDae, RefusesTransformsThatAreNone) {
  const auto refusalOf = [](const std::string& transform) {
    return refusal(
        file(kPolylist, "<node>" + transform + "<instance_geometry url=\"#g\"/></node>"));
  };
  for (const char* numbers : {"1 2 3 1 2 3 0 0 1", "0 0 5 0 0 0 0 0 1", "0 0 5 0 0 0 0 1e-9 -2",
                              "0 0 5 0 0 0 0 0 0", "1e308 0 0 -1e308 0 0 0 0 1"})
    EXPECT_THAT(refusalOf(std::string("<lookat>") + numbers + "</lookat>"),
                HasSubstr("lookat: must be a point, another point that is seen from it"))
        << numbers;
  for (const char* row : {"0.5 0 0 1", "0 0 1e-9 1", "0 0 0 2", "0 0 0 0"})
    EXPECT_THAT(refusalOf(std::string("<matrix>1 0 0 0 0 1 0 0 0 0 1 0 ") + row + "</matrix>"),
                HasSubstr("matrix: must end with 0 0 0 1"))
        << row;
  EXPECT_THAT(refusalOf("<rotate>0 0 0 90</rotate>"), HasSubstr("rotate: must have an axis"));
  EXPECT_EQ(refusalOf("<rotate>0 0 0 0</rotate>"), "read");
}

TEST(ReadDae, TakesWhatAControllerBendsAsItIs) {
  const auto bentBy = [](const std::string& controllers) {
    return file(kPolylist, "<node><instance_controller url=\"#c\"/></node>", controllers);
  };
  const std::string skin = "<controller id=\"c\"><skin source=\"#g\"/></controller>";
  EXPECT_DOUBLE_EQ(volume(solidIn(bentBy(skin))), 1);
  const std::string morph = "<controller id=\"c\"><morph source=\"#d\"/></controller>";
  EXPECT_DOUBLE_EQ(
      volume(solidIn(bentBy(morph + "<controller id=\"d\"><skin source=\"#g\"/></controller>"))),
      1);
  const std::string circle = "<controller id=\"d\"><skin source=\"#c\"/></controller>";
  EXPECT_THAT(refusal(bentBy(morph + circle)), HasSubstr("geometry"));
  EXPECT_THAT(refusal(bentBy("<controller id=\"c\"/>")), HasSubstr("missing element morph"));
}

TEST(ReadDae, KnowsHowItsNumbersWereRounded) {
  // single precision at 1, and two digits count as six, the last of them in 1e-5
  EXPECT_NEAR(readDae(file(kPolylist)).rounding.x(), 1.5e-5 + 4.77e-7, 1e-9);
  const std::string scaled = "<node><scale>10 1 1</scale><instance_geometry url=\"#g\"/></node>";
  const Vector3d rounding = readDae(file(kPolylist, scaled)).rounding;
  EXPECT_NEAR(rounding.x() / rounding.y(), 10, 1e-12);
}

TEST(ReadDae, SaysWhatIsWrongAndWhere) {
  const auto replaced = [](std::string text, const std::string& old, const std::string& by) {
    const std::size_t at = text.find(old);
    EXPECT_NE(at, std::string::npos) << old;
    return text.replace(at, old.size(), by);
  };
  const std::string good = file(kPolylist);
  EXPECT_EQ(refusal(good), "read");
  EXPECT_EQ(refusal("<scene/>"), kRefused + "its root must be the element COLLADA");
  EXPECT_EQ(refusal("<COLLADA></COLLADA>"), kRefused + "line 1: COLLADA: missing element scene");
  EXPECT_THAT(refusal("<COLLADA><a></COLLADA>"), HasSubstr("no well-formed XML"));
  EXPECT_EQ(refusal(replaced(good, "0 0 0 1 0 0", "0 zero 0 1 0 0")),
            kRefused + "line 2: must be a number, got 'zero'");
  EXPECT_EQ(refusal(replaced(good, "0 2 3 1", "0 2 3 8")),
            kRefused + "line 4: p: index must be below the number of vertices, 8, got 8");
  EXPECT_EQ(refusal(replaced(good, "0 2 3 1", "0 2 3 -1")),
            kRefused + "line 4: must be an index, got '-1'");
  EXPECT_EQ(refusal(replaced(good, "0 2 3 1", "0 2 3")),
            kRefused + "line 4: polylist: must have as many corners as its polygons, got 23");
  EXPECT_EQ(refusal(replaced(good, "url=\"#g\"", "url=\"other.dae#g\"")),
            kRefused +
                "line 7: instance_geometry: url must name an element of this file by #id, "
                "got 'other.dae#g'");
  EXPECT_EQ(refusal(replaced(good, "url=\"#g\"", "url=\"#v\"")),
            kRefused + "line 7: instance_geometry: url must name a geometry, got a vertices");
  EXPECT_THAT(refusal(replaced(good, "count=\"8\"", "count=\"9\"")),
              HasSubstr("line 2: accessor: must name three numbers of each entry"));
  EXPECT_THAT(refusal(replaced(good, "stride=\"3\"", "stride=\"18446744073709551615\"")),
              HasSubstr("line 2: accessor: must name three numbers of each entry"));
  EXPECT_THAT(refusal(replaced(good, "offset=\"0\"", "offset=\"1000\"")),
              HasSubstr("offset must be below 1000"));
  EXPECT_THAT(refusal(replaced(good, "<p>", "<ph><p/></ph><p>")),
              HasSubstr("polygons with holes are not supported"));
  EXPECT_THAT(refusal(replaced(good, "<instance_g", "<skew>1 2 3 4 5 6 7</skew><instance_g")),
              HasSubstr("skew: is not supported"));
  EXPECT_THAT(refusal(replaced(good, "<instance_g", "<scale>1 2</scale><instance_g")),
              HasSubstr("scale: must be 3 numbers, got 2"));
  EXPECT_THAT(refusal(replaced(good, "<COLLADA>", "<COLLADA><asset><unit meter=\"0\"/></asset>")),
              HasSubstr("unit: meter must be one number > 0, got '0'"));
  const std::string long_unit = "<COLLADA><asset><unit meter=\"1 \n" + std::string(2000, 'x');
  EXPECT_THAT(
      refusal(replaced(good, "<COLLADA>", long_unit + "\"/></asset>")),
      ::testing::AllOf(::testing::Not(HasSubstr("\n")), ::testing::SizeIs(::testing::Lt(200U))));
}

}  // namespace rigid_body_sim
