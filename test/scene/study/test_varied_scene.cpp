#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigid_body_sim/scene/build_world.hpp>
#include <rigid_body_sim/scene/load_scene.hpp>

#include "scene/study/reaches.hpp"
#include "scene/study/read_back.hpp"
#include "scene/study/varied_scene.hpp"

namespace rigid_body_sim {
namespace {

const std::string kVariedScene = R"(gravity: [0, 0, -9.8]
time_step: 0.01
bodies:
  - name: box
    shape: {box: [1.0, 0.5, 0.25]}
    mass: 2
    twist: {frame: body, linear: [1, 0, 0], angular: [0.2, 1.5, 0.4]}
    drag: {linear: 0.5}
    points: {tip: {position: [1, 0, 0]}, idle: {position: [0, 1, 0]}}
  - {name: ball, shape: {sphere: {radius: 0.1}}, density: 700, position: [5, 0, 0]}
forces:
  - {type: spring, from: {body: box}, to: {body: ball}, stiffness: 4, rest_length: 3}
wrenches:
  - {body: box, frame: box/tip, point_frame: box/tip, force: [0, 0, 1], start: 0.5, duration: 1}
)";

Study studyVarying(const std::vector<std::string>& paths) {
  std::string text = "runs: 1\nvary:\n";
  for (const std::string& path : paths) text += "  " + path + ": {list: [1]}\n";
  return parseStudy(text, "study.yaml");
}

SceneValue number(const std::string& text) { return {{{text}}, false}; }

ReadContext contextOf(const std::string& source) {
  ReadContext context;
  context.source = source;
  return context;
}

std::string pathFault(const std::vector<std::string>& paths) {
  try {
    VariedScene(kVariedScene, contextOf("scene.yaml"), studyVarying(paths));
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

// A tolerance that is stated bounds series, too: whether it is must not depend on earlier draws.
TEST(VariedScene, StatesWhatVariesWhateverWasDrawnBefore) {
  VariedScene scene(kVariedScene, contextOf("scene.yaml"), studyVarying({"tolerance"}));
  EXPECT_TRUE(scene.read().tolerance_stated);
  scene.set(0, scene.own(0));
  EXPECT_TRUE(scene.scene().tolerance_stated);
}

// The nodes that are added refer to texts that must last.
TEST(VariedScene, KeepsTheTextsOfKeysThatItAdds) {
  VariedScene scene(kVariedScene, contextOf("scene.yaml"),
                    studyVarying({"tolerance", "horizon", "integrator", "bodies.box.orientation",
                                  "bodies.box.mass", "wrenches[0].force"}));
  EXPECT_EQ(scene.own(0).words[0].text, "1e-9");
  EXPECT_EQ(scene.own(1).words[0].text, "10");
  EXPECT_EQ(scene.own(2).words[0].text, "auto");
  scene.set(4, number("3"));
  EXPECT_EQ(scene.scene().horizon, 10);
  EXPECT_NE(scene.yaml().find("tolerance: 1e-9"), std::string::npos) << scene.yaml();
}

// A number is read where it was found already, and a text where there is none.
TEST(VariedScene, ReadsAKeyOfAWrenchByItself) {
  const std::vector<std::string> paths = {"wrenches[0].force[1]", "wrenches[0].frame",
                                          "wrenches[0].duration"};
  VariedScene scene(kVariedScene, contextOf("scene.yaml"), studyVarying(paths));
  scene.set(0, SceneValue::of(-0.25));
  scene.set(1, number("world"));
  const WrenchDef& wrench = scene.scene().wrenches[0];
  EXPECT_EQ(wrench.force, Vector3d(0, -0.25, 1));
  EXPECT_EQ(wrench.frame, "world");
  EXPECT_EQ(wrench.point_frame, "box/tip");
  scene.set(2, SceneValue::of(-1));
  try {
    scene.scene();
    FAIL() << "a duration below zero is taken";
  } catch (const SceneError& error) {
    EXPECT_STREQ(error.what(), "scene.yaml:14: wrenches[0]: duration must be > 0 s, got -1");
  }
  scene.set(2, SceneValue::of(std::numeric_limits<double>::infinity()));
  EXPECT_THROW(scene.scene(), SceneError);
  scene.set(2, scene.own(2));
  EXPECT_EQ(scene.scene().wrenches[0].duration, 1);
}

TEST(VariedScene, SetsValuesAsIfTheyStoodInTheFile) {
  const std::vector<std::string> paths = {"bodies.box.mass",       "bodies.box.twist.angular[2]",
                                          "bodies.ball.density",   "forces[0].stiffness",
                                          "wrenches[0].force[2]",  "gravity[2]",
                                          "bodies[1].position[0]", "tolerance"};
  VariedScene scene(kVariedScene, contextOf("scene.yaml"), studyVarying(paths));
  for (std::size_t i = 0; i < paths.size(); ++i)
    scene.set(i, number(std::to_string(i + 1) + ".25"));
  const Scene& read = scene.scene();
  EXPECT_EQ(std::get<SolidDef>(read.bodies[0].composition).mass, 1.25);
  EXPECT_EQ(read.bodies[0].twist.angular, Vector3d(0.2, 1.5, 2.25));
  EXPECT_EQ(std::get<SpringDef>(read.forces[0].law).stiffness, 4.25);
  EXPECT_EQ(read.wrenches[0].force.z(), 5.25);
  EXPECT_EQ(read.gravity->z(), 6.25);
  EXPECT_EQ(read.bodies[1].position.x(), 7.25);
  EXPECT_EQ(read.tolerance, 8.25);
  // and the file that is written of it is the same scene
  const Scene again = parseScene(scene.yaml(), "again.yaml");
  const World world = buildWorld(read), same = buildWorld(again);
  EXPECT_FALSE(differInMotion(world, initialState(read, world), same, initialState(again, same)));
}

// What is set without a reader is what the reader makes of the file that says it.
TEST(VariedScene, SetsANumberAsTheReaderWould) {
  const std::vector<std::string> paths = {
      "bodies.box.mass",         "bodies.box.twist.linear[1]", "bodies.box.twist.angular[0]",
      "bodies.ball.position[0]", "bodies.ball.density",        "bodies.box.points.tip.position[0]",
      "wrenches[0].force[0]",    "wrenches[0].start",          "wrenches[0].duration",
      "forces[0].to.point[1]",   "bodies.box.drag.linear",     "bodies.box.shape.box[2]"};
  const std::string text = kVariedScene +
                           "  - {body: box, frame: world, force: [1, 2, 3], "
                           "torque: [4, 5, 6], point: [7, 8, 9], duration: 2}\n";
  std::string with_end = text;
  with_end.replace(with_end.find("to: {body: ball}"), 16, "to: {body: ball, point: [0, 0, 0]}");
  std::vector<std::string> all = paths;
  for (const char* more : {"wrenches[1].torque[2]", "wrenches[1].point[1]"}) all.push_back(more);
  VariedScene scene(with_end, contextOf("scene.yaml"), studyVarying(all));
  for (const std::size_t alone : {all.size(), std::size_t{0}, std::size_t{6}}) {
    for (std::size_t i = 0; i < all.size(); ++i)
      if (alone == all.size() || alone == i)
        scene.set(i, SceneValue::of(0.1 * static_cast<double>(i + alone + 1)));
    const Scene& set = scene.scene();
    const Scene read = parseScene(scene.yaml(), "scene.yaml");
    const World world = buildWorld(set), same = buildWorld(read);
    EXPECT_FALSE(differInMotion(world, initialState(set, world), same, initialState(read, same)))
        << alone;
  }
  // and what it refuses is refused
  for (const auto& [index, fault] : {std::pair<std::size_t, std::string>{0, "mass must be > 0 kg"},
                                     {7, "start must be >= 0 s"},
                                     {8, "duration must be > 0 s"}}) {
    scene.set(index, SceneValue::of(-1));
    try {
      scene.scene();
      ADD_FAILURE() << fault;
    } catch (const SceneError& error) {
      EXPECT_NE(std::string(error.what()).find(fault + ", got -1"), std::string::npos)
          << error.what();
    }
    scene.set(index, SceneValue::of(1));
    EXPECT_NO_THROW(scene.scene());
  }
}

TEST(VariedScene, ReadsAgainOnlyWhatChanged) {
  VariedScene scene(kVariedScene, contextOf("scene.yaml"), studyVarying({"bodies.box.mass"}));
  scene.set(0, number("3"));
  EXPECT_EQ(std::get<SolidDef>(scene.scene().bodies[0].composition).mass, 3);
  scene.set(0, scene.own(0));
  EXPECT_EQ(std::get<SolidDef>(scene.scene().bodies[0].composition).mass, 2);
  EXPECT_EQ(scene.scene().bodies[1].name, "ball");
}

TEST(VariedScene, RefusesAValueAsTheFileWould) {
  VariedScene scene(kVariedScene, contextOf("scene.yaml"), studyVarying({"bodies.box.mass"}));
  scene.set(0, number("-2"));
  for (int attempt = 0; attempt < 2; ++attempt) try {
      scene.scene();
      ADD_FAILURE();
    } catch (const SceneError& error) {
      EXPECT_STREQ(error.what(), "scene.yaml:6: body 'box': mass must be > 0 kg, got -2");
    }
  scene.set(0, number("2"));
  EXPECT_NO_THROW(scene.scene());
}

TEST(VariedScene, NamesTheNearestPath) {
  const std::string left_out = "; a key that the scene leaves out must be written into it first";
  EXPECT_EQ(pathFault({"bodies.box.masss"}),
            "study.yaml:3: vary: 'bodies.box.masss' is not in scene.yaml; the nearest that is: "
            "'bodies.box.mass'" +
                left_out);
  EXPECT_EQ(pathFault({"wrenches[1].start"}),
            "study.yaml:3: vary: 'wrenches[1].start' is not in scene.yaml; the nearest that is: "
            "'wrenches[0].start'" +
                left_out);
  EXPECT_NE(pathFault({"bodies.box.twist.angular[3]"}).find("nearest"), std::string::npos);
  EXPECT_NE(pathFault({"bodies..mass"}).find("nearest"), std::string::npos);
}

TEST(VariedScene, RefusesPathsThatCannotVary) {
  EXPECT_EQ(pathFault({"bodies.box.name"}),
            "study.yaml:3: vary: 'bodies.box.name' is a name, which cannot vary");
  EXPECT_EQ(pathFault({"bodies.box.twist"}),
            "study.yaml:3: vary: 'bodies.box.twist' holds more than a value or a list of values; "
            "name one within it");
  EXPECT_EQ(pathFault({"gravity", "gravity[2]"}),
            "study.yaml:4: vary: 'gravity[2]' is part of 'gravity', which varies, too");
  EXPECT_EQ(pathFault({"bodies.box.mass", "bodies[0].mass"}),
            "study.yaml:3: vary: 'bodies.box.mass' is the same value as 'bodies[0].mass', which "
            "varies, too");
}

TEST(DifferInMotion, SeesWhatReachesTheWorldAndNothingElse) {
  const auto reaches = [](const std::string& path, const std::string& value) {
    VariedScene scene(kVariedScene, contextOf("scene.yaml"), studyVarying({path}));
    const World before = buildWorld(scene.scene());
    const State start = initialState(scene.scene(), before);
    scene.set(0, number(value));
    const World after = buildWorld(scene.scene());
    return differInMotion(before, start, after, initialState(scene.scene(), after));
  };
  EXPECT_TRUE(reaches("bodies.box.drag.linear", "0.6"));
  EXPECT_TRUE(reaches("forces[0].rest_length", "3.5"));
  EXPECT_TRUE(reaches("bodies.ball.shape.sphere.radius", "0.2"));
  EXPECT_TRUE(reaches("wrenches[0].duration", "2"));
  EXPECT_TRUE(reaches("bodies.box.points.tip.position[0]", "2"));
  EXPECT_FALSE(reaches("bodies.box.points.idle.position[0]", "2"));
}

TEST(ReadBack, FindsEveryValueInTheBuiltWorld) {
  const std::vector<std::pair<std::string, double>> cases = {
      {"bodies.box.mass", 3},        {"bodies.box.twist.angular[2]", 2}, {"gravity[2]", -1},
      {"bodies[1].position[0]", -4}, {"wrenches[0].start", 0.75},        {"time_step", 0.125},
      {"wrenches[0].duration", 2},   {"bodies.box.twist.linear[1]", 7},  {"tolerance", 1e-4}};
  for (const auto& [path, value] : cases) {
    VariedScene scene(kVariedScene, contextOf("scene.yaml"), studyVarying({path}));
    scene.set(0, number(std::to_string(value)));
    const World world = buildWorld(scene.scene());
    const auto read = ReadBack(path, scene.bodyOf(0))
                          .numbers(scene.scene(), world, initialState(scene.scene(), world));
    ASSERT_TRUE(read) << path;
    ASSERT_EQ(read->size(), 1) << path;
    EXPECT_NEAR((*read)[0], value, 1e-14) << path;
  }
}

// On a pivot, the body is kept by its inertia about that point.
TEST(ReadBack, FindsMassPropertiesAndAttitudeWithAndWithoutAPivot) {
  const std::vector<std::pair<std::string, double>> cases = {
      {"mass", 3},           {"center_of_mass[0]", 0.4}, {"center_of_mass[2]", -0.3},
      {"inertia.ixx", 2.25}, {"inertia.iyy", 1.75},      {"inertia.izz", 2.5},
      {"inertia.ixy", 0.25}, {"inertia.ixz", -0.125},    {"inertia.iyz", 0.2}};
  const std::string body = R"(time_step: 0.01
bodies:
  - name: box
    mass: 2
    center_of_mass: [0.1, 0.2, 0.3]
    inertia: {ixx: 2, iyy: 2.2, izz: 2.4, ixy: 0.1, ixz: 0.05, iyz: -0.1}
    orientation: [0.5, 0.5, 0.5, 0.5]
)";
  for (const char* pivot : {"", "    pivot: {point: [0.7, -0.4, 0.2]}\n"}) {
    const auto readBack = [&](const std::string& key, const SceneValue& value) {
      const std::string path = "bodies.box." + key;
      VariedScene scene(body + pivot, contextOf("scene.yaml"), studyVarying({path}));
      scene.set(0, value);
      const World world = buildWorld(scene.scene());
      return ReadBack(path, scene.bodyOf(0))
          .numbers(scene.scene(), world, initialState(scene.scene(), world))
          .value_or(ReadBack::Numbers());
    };
    for (const auto& [key, value] : cases) {
      const ReadBack::Numbers read = readBack(key, number(std::to_string(value)));
      ASSERT_EQ(read.size(), 1) << key;
      EXPECT_NEAR(read[0], value, 1e-14) << key << pivot;
    }
    const std::vector<double> q = {0.1, -0.7, 0.1, 0.7};
    const ReadBack::Numbers read =
        readBack("orientation", {{{"0.1"}, {"-0.7"}, {"0.1"}, {"0.7"}}, true});
    ASSERT_EQ(read.size(), 4);
    const double sign = read[3] < 0 ? -1 : 1;
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_NEAR(sign * read[static_cast<Eigen::Index>(i)], q[i], 1e-14) << pivot;
  }
}

TEST(ReadBack, ShowsAValueThatTheWorldDoesNotHave) {
  const auto in_world = [](double x) -> ReadBack::Numbers {
    return ReadBack::Numbers::Constant(1, x);
  };
  EXPECT_FALSE(otherReadBack(SceneValue::of(2), in_world(2 + 1e-13)));
  const std::optional<SceneValue> other = otherReadBack(SceneValue::of(2), in_world(2.5));
  ASSERT_TRUE(other);
  EXPECT_EQ(other->words[0].text, "2.5");
  EXPECT_FALSE(other->is_list);
}

}  // namespace rigid_body_sim
