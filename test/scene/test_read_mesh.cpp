#include <cctype>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <rigid_body_sim/mass/checked_mesh.hpp>

#include "scene/meshes/read_mesh.hpp"
#include "support/mass_difference.hpp"
#include "support/mesh_edits.hpp"
#include "support/mesh_texts.hpp"
#include "support/triangulations.hpp"

namespace rigid_body_sim {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

/// A directory for the files of one test, gone afterwards.
class ReadMesh : public ::testing::Test {
 protected:
  void SetUp() override {
    directory_ = std::filesystem::temp_directory_path() /
                 ("rigid_body_sim_read_mesh_" + std::to_string(getpid()));
    std::filesystem::create_directories(directory_);
  }
  void TearDown() override { std::filesystem::remove_all(directory_); }

  std::string path(const std::string& name) const { return (directory_ / name).string(); }

  std::string written(const std::string& name, const std::string& content) const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }

  /// The one line that a file is refused with, without its path; "read" for one that is not.
  static std::string refusal(const std::string& file) {
    try {
      readMesh(file);
    } catch (const std::runtime_error& error) {
      const std::string line = error.what();
      EXPECT_THAT(line, StartsWith(file + ": "));
      EXPECT_THAT(line, Not(HasSubstr("\n")));
      return line.substr(file.size() + 2);
    }
    return "read";
  }

 private:
  std::filesystem::path directory_;
};

/// A brick off the origin with corners that single precision holds exactly.
TriangleMesh brick() { return translated({2, 0.5, -1}, triangulated(Box{{1, 2, 0.5}}, 0)); }

void expectBrick(const TriangleMesh& mesh, double scale, double tolerance) {
  const CheckedMesh checked = checkedMesh(mesh);
  EXPECT_EQ(checked.fault, "");
  EXPECT_THAT(checked.notices, IsEmpty());
  EXPECT_TRUE(sameMass(massProperties(checked.mesh, 1), massProperties(scaled(scale, brick()), 1),
                       tolerance));
}

}  // namespace

TEST_F(ReadMesh, ReadsStlAsciiAndBinary) {
  expectBrick(readMesh(written("ascii.stl", asciiStl(brick()))).mesh, 1, 1e-15);
  expectBrick(readMesh(written("binary.stl", binaryStl(brick()))).mesh, 1, 1e-15);
  expectBrick(readMesh(written("UPPER.STL", binaryStl(brick()))).mesh, 1, 1e-15);
  std::string capitals = asciiStl(brick());
  for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  expectBrick(readMesh(written("capitals.stl", capitals)).mesh, 1, 1e-15);
}

TEST_F(ReadMesh, ReadsABinaryStlThatCallsItselfSolid) {
  std::string content = binaryStl(brick());
  content.replace(0, 11, "solid brick");
  expectBrick(readMesh(written("solid.stl", content)).mesh, 1, 1e-15);
}

TEST_F(ReadMesh, ReadsObjWithTrianglesAndPolygons) {
  expectBrick(readMesh(written("triangles.obj", obj(brick()))).mesh, 1, 1e-15);
  expectBrick(readMesh(written("quads.obj", kBrickOfQuads)).mesh, 1, 1e-15);
  std::string commented = "\xEF\xBB\xBF";
  for (const char* c = kBrickOfQuads; *c != '\0'; ++c)
    commented += *c == '\n' ? " # f 1 2 3\n" : std::string(1, *c);
  expectBrick(readMesh(written("commented.obj", commented)).mesh, 1, 1e-15);
}

TEST_F(ReadMesh, ReadsDaeInItsUnitAndWithItsTransformsButNotItsUpAxis) {
  // the vertices in centimetres, half a metre too low, put right by the node's translation
  expectBrick(readMesh(written("brick.dae", dae(brick()))).mesh, 1, 1e-14);
}

TEST_F(ReadMesh, ReadsTextsWithAByteOrderMarkOrLinesThatEndInCarriageReturns) {
  for (const auto& [name, text] :
       {std::pair{"brick.stl", asciiStl(brick())}, std::pair{"brick.obj", obj(brick())},
        std::pair{"commented.obj", "# v 1\n" + obj(brick())}}) {
    expectBrick(readMesh(written(name, "\xEF\xBB\xBF" + text)).mesh, 1, 1e-15);
    std::string cr = text, crlf;
    for (char& c : cr) {
      crlf += c == '\n' ? "\r\n" : std::string(1, c);
      if (c == '\n') c = '\r';
    }
    expectBrick(readMesh(written(name, cr)).mesh, 1, 1e-15);
    expectBrick(readMesh(written(name, crlf)).mesh, 1, 1e-15);
  }
  expectBrick(readMesh(written("dos.dae", "\xEF\xBB\xBF" + dae(brick()))).mesh, 1, 1e-14);
  for (const char* end : {"\n", "\r", "\r\n"})
    EXPECT_EQ(refusal(written("wrong.stl", std::string("solid a") + end + end + "mesh" + end)),
              "mesh file cannot be read: line 3: must be facet, solid or endsolid, got 'mesh'");
}

TEST_F(ReadMesh, ScalesEachAxisAndKeepsTheOutsideOfAMirroredMeshOutside) {
  const std::string file = written("binary.stl", binaryStl(brick()));
  for (const Vector3d& scale :
       {Vector3d(2, 0.5, 3), Vector3d(-2, 0.5, 3), Vector3d(-2, -0.5, 3), Vector3d(-2, -0.5, -3)}) {
    const TriangleMesh mesh = readMesh(file, scale).mesh;
    EXPECT_DOUBLE_EQ(volume(mesh), scale.cwiseAbs().prod());
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
      EXPECT_EQ(mesh.vertices[i], readMesh(file).mesh.vertices[i].cwiseProduct(scale));
  }
}

TEST_F(ReadMesh, Scales) {
  const std::string file = written("binary.stl", binaryStl(brick()));
  expectBrick(readMesh(file, Vector3d::Constant(0.001)).mesh, 0.001, 1e-14);
}

TEST_F(ReadMesh, RefusesWhatIsNoFile) {
  EXPECT_EQ(refusal(path("missing.stl")), "mesh file does not exist");
  std::filesystem::create_directory(path("directory.stl"));
  EXPECT_EQ(refusal(path("directory.stl")), "mesh file must be a regular file");
  EXPECT_EQ(refusal(written("brick.xyz", asciiStl(brick()))),
            "mesh file must end in .stl, .obj or .dae, got '.xyz'");
}

TEST_F(ReadMesh, RefusesTruncatedBinaryStl) {
  const std::string whole = binaryStl(brick());
  EXPECT_EQ(refusal(written("cut.stl", whole.substr(0, 84 + 50 * 7 + 13))),
            "binary STL is truncated: its header claims 12 triangles, 684 bytes, got 447 bytes");
  EXPECT_EQ(refusal(written("header.stl", whole.substr(0, 50))),
            "binary STL must have a header of 84 bytes, got 50 bytes");
  EXPECT_EQ(refusal(written("empty.stl", "")),
            "binary STL must have a header of 84 bytes, got 0 bytes");
}

TEST_F(ReadMesh, RefusesAHeaderThatClaimsGigabytes) {
  for (const std::uint32_t claimed : {43000000u, 85899346u, 0xffffffffu}) {  // 2 GB; wraps 2³²; all
    std::string content = binaryStl(brick());
    std::memcpy(&content[80], &claimed, 4);
    EXPECT_THAT(refusal(written("claim.stl", content)),
                StartsWith("binary STL is truncated: its header claims " + std::to_string(claimed) +
                           " triangles, "));
    content.replace(0, 6, "solid ");
    EXPECT_THAT(refusal(written("solid.stl", content)), HasSubstr("binary STL is truncated"));
  }
}

TEST_F(ReadMesh, RefusesCoordinatesThatAreNotFinite) {
  for (const char* wrong : {"nan", "NaN", "inf", "-inf", "1e999"}) {
    std::string content = asciiStl(brick());
    content.replace(content.find("1.5"), 3, wrong);
    // a reader may take the word for a number or not: refused in either case
    EXPECT_THAT(refusal(written("wrong.stl", content)), StartsWith("mesh ")) << wrong;
  }
}

TEST_F(ReadMesh, TellsTheCoordinatesThatAreNotFinite) {
  std::string content = binaryStl(brick());
  const float infinite = std::numeric_limits<float>::infinity();
  std::memcpy(&content[84 + 50 + 12 + 4], &infinite, 4);  // second triangle, first corner, y
  EXPECT_EQ(refusal(written("wrong.stl", content)),
            "mesh vertices must be finite, got [2.5 inf -1.25]");
}

TEST_F(ReadMesh, RefusesFilesWithoutTriangles) {
  EXPECT_THAT(refusal(written("none.stl", "solid none\nendsolid none\n")), StartsWith("mesh "));
  EXPECT_THAT(refusal(written("zero.stl", binaryStl({}))), StartsWith("mesh "));
  EXPECT_THAT(refusal(written("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n")), StartsWith("mesh "));
  EXPECT_THAT(refusal(written("empty.obj", "")), StartsWith("mesh "));
  EXPECT_THAT(refusal(written("empty.dae", "")), StartsWith("mesh "));
}

TEST_F(ReadMesh, RefusesOrSurvivesEveryTruncation) {
  // no crash and no throw of another kind, wherever the file ends
  for (const auto& [name, whole] :
       {std::pair{"cut.stl", asciiStl(brick())}, std::pair{"cut.obj", obj(brick())},
        std::pair{"cut.dae", dae(brick())}})
    for (std::size_t length = 0; length < whole.size(); length += 37)
      EXPECT_NO_THROW(refusal(written(name, whole.substr(0, length)))) << name << " " << length;
}

}  // namespace rigid_body_sim
