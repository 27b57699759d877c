#include <filesystem>
#include <stdexcept>
#include <string>

#include <gtest/gtest.h>

#include <rigid_body_sim/mass/checked_mesh.hpp>

#include "scene/limits.hpp"
#include "scene/meshes/read_mesh.hpp"
#include "scene/urdf/read_urdf.hpp"
#include "support/mesh_texts.hpp"
#include "support/temporary_directory.hpp"
#include "support/triangulations.hpp"

namespace rigid_body_sim {
namespace {

class MeshLimit : public ::testing::Test {
 protected:
  /// The line that a file is refused with, without its path; "read" for one that is not.
  std::string refusal(const std::string& name, const std::string& content) const {
    const std::string path = directory_.written(name, content);
    try {
      if (std::filesystem::path(path).extension() == ".urdf")
        readUrdf(path);
      else
        readMesh(path);
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).substr(path.size() + 2);
    }
    return "read";
  }

  /// Grown, not written: a file of that size costs no disk.
  std::string refusalOfSize(const std::string& name, std::size_t bytes) const {
    const std::string path = directory_.written(name, "");
    std::filesystem::resize_file(path, bytes);
    try {
      readMesh(path);
    } catch (const std::runtime_error& error) {
      return std::string(error.what()).substr(path.size() + 2);
    }
    return "read";
  }

  TemporaryDirectory directory_;
};

std::string nested(std::size_t levels) {
  std::string xml;
  for (std::size_t i = 0; i < levels; ++i) xml += "<a>";
  return xml;
}

const std::string kNotXml = "mesh file cannot be read: ";
const std::string kNotUrdf = "is not a URDF file that can be read: ";

}  // namespace

TEST_F(MeshLimit, IsOneOfBytes) {
  EXPECT_EQ(refusalOfSize("large.stl", kMaxMeshBytes + 1), "is larger than 256 MiB");
  EXPECT_EQ(refusalOfSize("large.dae", kMaxDaeBytes + 1), "is larger than 64 MiB");
}

TEST_F(MeshLimit, IsOneOfTriangles) {
  std::string face = "v 0 0 0\nf";
  for (std::size_t i = 0; i < kMaxTriangles + 3; ++i) face += " 1";
  EXPECT_EQ(refusal("fan.obj", face), "mesh must have at most 10000000 triangles");
}

TEST_F(MeshLimit, IsOneOfTheDepthOfXml) {
  const std::string too_deep = "elements nested deeper than 100 levels";
  EXPECT_EQ(refusal("deep.dae", nested(101)), kNotXml + too_deep);
  EXPECT_EQ(refusal("deep.dae", nested(1000000)), kNotXml + too_deep);
  EXPECT_EQ(refusal("deep.urdf", nested(1000000)), kNotUrdf + too_deep);
  EXPECT_EQ(refusal("wide.urdf", "<robot name='r'><link name='l'/>" + std::string(101, ' ') +
                                     "<!-- <a><a> --><![CDATA[<a><a>]]></robot>"),
            "read");
}

TEST_F(MeshLimit, CountsNoEndThatXmlDoesNotHave) {
  // a reader that takes what is quoted here for tags, or the other way round, could be led deeper
  std::string quoted;
  for (int i = 0; i < 200; ++i) quoted += "<a x=\"</a>\">";
  EXPECT_EQ(refusal("quoted.dae", quoted), kNotXml + "a < within a tag");
  std::string commented;
  for (int i = 0; i < 200; ++i) commented += "<a><!-- </a> -->";
  EXPECT_EQ(refusal("commented.dae", commented),
            kNotXml + "elements nested deeper than 100 levels");
}

TEST_F(MeshLimit, IsOneOfTheNodesOfDaeThatLieInOneAnother) {
  std::string looped = dae(triangulated(Box{{1, 1, 1}}, 0));
  looped.replace(looped.find("<instance_geometry url=\"#g\"/>"), 29, "<instance_node url=\"#n\"/>");
  EXPECT_EQ(refusal("looped.dae", looped),
            kNotXml + "line 11: node: must lie within at most 100 nodes, and not within itself");
}

TEST_F(MeshLimit, IsOneOfTheInstancesOfDae) {
  // each node holds the next one twice: 2^30 instances, with and without triangles
  std::string nodes, text = dae(triangulated(Box{{1, 1, 1}}, 0));
  for (int i = 0; i < 30; ++i) {
    const std::string next = "<instance_node url=\"#n" + std::to_string(i + 1) + "\"/>";
    nodes += "<node id=\"n" + std::to_string(i) + "\">" + next + next + "</node>";
  }
  for (const char* last : {"", "<instance_geometry url=\"#g\"/>"}) {
    std::string doubled = text;
    doubled.insert(
        doubled.find("<library_visual_scenes>"),
        "<library_nodes>" + nodes + "<node id=\"n30\">" + last + "</node></library_nodes>");
    doubled.replace(doubled.rfind("<instance_geometry url=\"#g\"/>"), 29,
                    "<instance_node url=\"#n0\"/>");
    const std::string line = refusal("doubled.dae", doubled);
    EXPECT_TRUE(line.find("must be one of at most 1000000 nodes, instances counted") !=
                    std::string::npos ||
                line == "mesh must have at most 10000000 triangles")
        << line;
  }
}

TEST_F(MeshLimit, TellsTheLineOfAsciiStlThatIsNoStl) {
  const std::string facet = "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n";
  EXPECT_EQ(refusal("a.stl", facet + "vertex 0 1\nvertex 1 1 1\n"),
            kNotXml + "line 6: must be a number, got 'vertex'");
  EXPECT_EQ(refusal("a.stl", facet + "endloop\n"),
            kNotXml + "line 5: must be vertex, got 'endloop'");
  EXPECT_EQ(refusal("a.stl", facet), kNotXml + "line 5: must be vertex, got ''");
  EXPECT_EQ(refusal("a.stl", "solid a\nmesh\n"),
            kNotXml + "line 2: must be facet, solid or endsolid, got 'mesh'");
}

TEST_F(MeshLimit, TellsTheLineOfObjThatIsNoObj) {
  const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_EQ(refusal("a.obj", "v 0 0\n"), kNotXml + "line 1: must be a number, got ''");
  EXPECT_EQ(refusal("a.obj", "v 0 0 0 0.5\n"),
            kNotXml + "line 1: must be a vertex of weight 1, got '0.5'");
  EXPECT_EQ(refusal("a.obj", corners + "f 1 2\n"),
            kNotXml + "line 4: must be a face of three corners or more, got '2'");
  for (const char* wrong : {"0", "4", "-4", "-0", "1x", "99999999999999999999", "-", "/1"})
    EXPECT_EQ(refusal("a.obj", corners + "f 1 2 " + wrong + "\n"),
              kNotXml + "line 4: must be one of the 3 vertices before it, got '" + wrong + "'");
}

TEST_F(MeshLimit, ReadsWhatObjFilesDo) {
  const std::string path = directory_.written(
      "a.obj",
      "mtllib x.mtl\r\no brick\r\nv 0 0 0 1\r\nv 1 0 0 0.5 0.5 0.5\r\nv 0 1 0\r\nv 0 0 1.0e+0\r\n"
      "vn 0 0 1\r\nf -4/1/1 3//2 \\\r\n 2\r\nf 1 2 4\nf 2 3 4\n\tf 1 4 3");
  const CheckedMesh checked = checkedMesh(readMesh(path).mesh);
  EXPECT_EQ(checked.fault, "");
  EXPECT_EQ(volume(checked.mesh), 1.0 / 6);
}

TEST_F(MeshLimit, OfADentedPolygonIsNone) {
  // an arrow head, one unit thick: corner 1 does not see corner 3 within the polygon
  const std::string path = directory_.written(
      "arrow.obj",
      "v 2 -2 0\nv 0 0 0\nv 2 2 0\nv -2 0 0\nv 2 -2 1\nv 0 0 1\nv 2 2 1\nv -2 0 1\n"
      "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n");
  const CheckedMesh checked = checkedMesh(readMesh(path).mesh);
  EXPECT_EQ(checked.fault, "");
  EXPECT_EQ(std::abs(volume(checked.mesh)), 4);  // 8, that of the triangle, less the notch of 4
}

}  // namespace rigid_body_sim
