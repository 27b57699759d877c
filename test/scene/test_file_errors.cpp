#include <filesystem>

#include <gtest/gtest.h>

#include "scene_texts.hpp"
#include "support/temporary_directory.hpp"

namespace rigid_body_sim {
namespace {

std::string loadErrorOf(const std::string& path) {
  try {
    loadScene(path);
  } catch (const SceneError& e) {
    return e.what();
  }
  return "";
}

}  // namespace

TEST(SceneFile, IsRefusedWhenAbsent) {
  EXPECT_EQ(loadErrorOf("absent/x.yaml"),
            "absent/x.yaml: cannot be opened: No such file or directory (looked for in " +
                std::filesystem::current_path().string() + ")");
  EXPECT_EQ(loadErrorOf("/absent/x.yaml"),
            "/absent/x.yaml: cannot be opened: No such file or directory");
}

TEST(SceneFile, IsRefusedWhenADirectory) {
  EXPECT_EQ(loadErrorOf("/"), "/: is a directory, not a scene file");
}

TEST(SceneFile, IsRefusedWhereItIsAnotherByItsName) {
  EXPECT_EQ(loadErrorOf("absent/arm.PLY"),
            "absent/arm.PLY: unsupported file type .ply, and a scene is YAML text");
  EXPECT_EQ(loadErrorOf("arm.stl"),
            "arm.stl: is a mesh by its name, and a scene is YAML text; a body of it names the "
            "file, shape: {mesh: {file:}}");
  EXPECT_EQ(loadErrorOf("arm.urdf"),
            "arm.urdf: is a URDF file by its name, and a scene is YAML text; a body of it names "
            "the file, urdf: {file:}");
}

TEST(SceneFile, IsRefusedWhenLargerThan64MiB) {
  const TemporaryDirectory files;
  const std::string path = files.written("large.yaml", std::string((64 << 20) + 1, '#'));
  EXPECT_EQ(loadErrorOf(path), path + ": is larger than 64 MiB");
}

TEST(SceneFile, IsNamedInItsErrors) {
  const TemporaryDirectory files;
  const std::string path = files.written("bad.yaml", boxScene("    fixed: yes\n"));
  EXPECT_EQ(loadErrorOf(path), path + ":6: body 'box': fixed must be true or false, got yes");
}

TEST(SceneText, IsRefusedWhenEmpty) {
  EXPECT_EQ(errorOf(""), "s.yaml: is empty; it must be a YAML mapping");
  EXPECT_EQ(errorOf("# only a comment\n"), "s.yaml: is empty; it must be a YAML mapping");
  EXPECT_EQ(errorOf("---\n"), "s.yaml:2: a mapping is expected, got nothing");
}

TEST(SceneText, ThatIsNotYamlIsRefusedWithTheLineWhereTheMistakeMayBe) {
  EXPECT_EQ(errorOf("bodies:\n  - shape: {box: [1, 2, 3]\n    mass: 1\n"),
            "s.yaml:3: not YAML: did not find expected ',' or '}', while parsing a flow mapping "
            "that begins in line 2");
  EXPECT_EQ(errorOf("a: 1\nb: \"word\nc: 2\n"),
            "s.yaml:4: not YAML: found unexpected end of stream, while scanning a quoted scalar "
            "that begins in line 2");
  EXPECT_EQ(errorOf("time_step 0.01\nbodies:\n"),
            "s.yaml:2: not YAML: mapping values are not allowed in this context; or line 1 lacks a "
            "':'");
}

TEST(SceneText, IsRefusedWhenNotYaml) {
  EXPECT_EQ(errorOf("time_step: 0.01\nbodies: [}\n"),
            "s.yaml:2: not YAML: did not find expected node content");
  EXPECT_EQ(errorOf("a: b: c\n"),
            "s.yaml:1: not YAML: mapping values are not allowed in this context");
  EXPECT_EQ(errorOf("a: 1\nb: \xff\n"), "s.yaml:2: not YAML: invalid leading UTF-8 octet");
  EXPECT_EQ(errorOf("a: 1\n\nb: \x01\n"), "s.yaml:3: not YAML: control characters are not allowed");
}

TEST(SceneText, IsIndentedBySpaces) {
  const std::string tab = "not YAML: this line is indented by a tab; YAML indents by spaces";
  EXPECT_EQ(errorOf("time_step: 1\nbodies:\n\t- name: a\n"), "s.yaml:3: " + tab);
  EXPECT_EQ(errorOf("time_step: 1\nbodies:\n  - name: a\n  \tmass: 1\n"), "s.yaml:4: " + tab);
  EXPECT_EQ(errorOf("time_step:\t1\nbodies: [{name: a,\tshape: {sphere: {radius: 1}}, mass: 1}]\n"),
            "");
}

TEST(SceneText, IsReadWithAByteOrderMarkAndWithEndsOfLinesOfOtherSystems) {
  EXPECT_EQ(errorOf("\xef\xbb\xbf" + boxScene()), "");
  std::string other = boxScene("    fixed: yes\n");
  for (std::size_t at = 0; (at = other.find('\n', at)) != std::string::npos; at += 2)
    other.insert(at, 1, '\r');
  EXPECT_EQ(errorOf(other), "s.yaml:6: body 'box': fixed must be true or false, got yes");
}

TEST(SceneText, IsRefusedWhenNotAMapping) {
  EXPECT_EQ(errorOf("hello\n"), "s.yaml:1: a mapping is expected, got hello");
  EXPECT_EQ(errorOf("- 1\n- [2]\n"), "s.yaml:1: a mapping is expected, got [1, [2]]");
}

TEST(SceneText, IsOneDocument) {
  EXPECT_EQ(errorOf(boxScene("---\na: 1\n")),
            "s.yaml:6: a second YAML document; a scene file holds one");
}

TEST(SceneText, HasNoAnchorsAliasesOrTags) {
  const std::string refusal = "YAML anchors (&) and aliases (*) are not allowed";
  EXPECT_EQ(errorOf("gravity: &g [0, 0, 1]\n"), "s.yaml:1: " + refusal);
  EXPECT_EQ(errorOf("a: &x 1\nb: *x\n"), "s.yaml:1: " + refusal);
  EXPECT_EQ(errorOf("time_step: !!float 1\n"),
            "s.yaml:1: YAML tags are not allowed, got tag:yaml.org,2002:float");
}

TEST(SceneText, RepeatsNoKey) {
  EXPECT_EQ(errorOf("time_step: 0.01\ntime_step: 0.02\n"), "s.yaml:2: key 'time_step' is repeated");
  EXPECT_EQ(errorOf(boxScene("    mass: 2\n")), "s.yaml:6: key 'mass' is repeated");
}

TEST(SceneText, HasWordsForKeys) {
  EXPECT_EQ(errorOf("[1, 2]: 3\n"), "s.yaml:1: a key must be a word");
  EXPECT_EQ(errorOf("~: 3\n"), "s.yaml:1: a key must be a word");
}

TEST(SceneText, IsRefusedWhenNestedTooDeep) {
  const auto nested = [](std::size_t levels) {
    return "gravity: " + std::string(levels, '[') + "1" + std::string(levels, ']');
  };
  EXPECT_EQ(errorOf(nested(31)), "s.yaml:1: missing key 'time_step'");
  EXPECT_EQ(errorOf(nested(32)), "s.yaml:1: nested deeper than 32 levels");
  EXPECT_EQ(errorOf(nested(100000)), "s.yaml:1: nested deeper than 32 levels");
}

TEST(SceneText, NamesAFileOnOneLineWhateverItsBytes) {
  EXPECT_EQ(
      errorOf("time_step: 1\nbodies:\n- name: a\n  shape: {mesh: {file: \"/no\\nfile.stl\"}}\n"),
      "s.yaml:4: body 'a': shape.mesh.file: /no?file.stl: mesh file does not exist");
}

TEST(SceneText, IsQuotedOnOneLineHoweverLong) {
  const std::string error =
      errorOf("time_step: \"a\\nb" + std::string(1000, 'x') + "\"\nbodies: []\n");
  EXPECT_EQ(error,
            "s.yaml:1: time_step must be a number [s], got \"a?b" + std::string(57, 'x') + "...\"");
}

}  // namespace rigid_body_sim
