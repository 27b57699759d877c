#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/run_command.hpp"
#include "support/temporary_directory.hpp"

namespace rigid_body_sim {
namespace {

const std::string kMotionHeader = "time,body,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz\n";

class Plot : public ::testing::Test {
 protected:
  static test::Outcome plot(const std::string& arguments) {
    return test::runCommand(RIGID_BODY_SIM_PLOT " " + arguments + " 2>&1");
  }

  static std::string quoted(const std::string& path) { return "'" + path + "'"; }

  static std::string text(const std::string& path) {
    std::ostringstream all;
    all << std::ifstream(path).rdbuf();
    return all.str();
  }

  /// The pictures in a directory, by name.
  static std::vector<std::string> pictures(const std::string& directory) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(directory))
      if (entry.path().extension() == ".svg") names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
  }

  void refuses(const std::string& arguments, int code, const std::string& line) const {
    const test::Outcome run = plot(arguments);
    EXPECT_EQ(run.exit_code, code) << arguments;
    EXPECT_EQ(run.out, "plot: " + line + "\n");
  }

  TemporaryDirectory files;
};

/// The parts of an SVG file of gnuplot that draw a curve each.
std::vector<std::string> curvesIn(const std::string& svg) {
  const std::string begin = "<g id=\"gnuplot_plot_";
  std::vector<std::string> curves;
  for (std::size_t at = svg.find(begin); at != std::string::npos;) {
    const std::size_t next = svg.find(begin, at + 1);
    curves.push_back(svg.substr(at, next - at));
    at = next;
  }
  return curves;
}

std::size_t countOf(const std::string& what, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    ++count;
  return count;
}

/// Every curve has a line of at least two points, and every axis a unit.
void expectDrawn(const std::string& name, const std::string& svg, std::size_t panels) {
  EXPECT_NE(svg.find("</svg>"), std::string::npos) << name;
  const std::vector<std::string> curves = curvesIn(svg);
  EXPECT_GE(curves.size(), panels) << name;
  for (const std::string& curve : curves)
    EXPECT_NE(curve.find("L"), std::string::npos) << name << '\n' << curve;
  EXPECT_EQ(countOf("]</text>", svg), panels + 1) << name;  // with that of time
}

std::size_t panelsOf(const std::string& name) {
  return name == "energy" ? 1 : name == "momentum" ? 2 : 3;
}

}  // namespace

struct PlottedScene {
  const char* name;
  const char* options;
  std::vector<std::string> forces;  ///< pictures beside those that every run has
};

class PlotOfScene : public Plot, public ::testing::WithParamInterface<PlottedScene> {};

TEST_P(PlotOfScene, ShowsDataOnEveryAxis) {
  const PlottedScene& scene = GetParam();
  const std::string out = files.path("pictures of a run"), bag = files.path("run.bag");
  const test::Outcome run = test::runCommand(RIGID_BODY_SIM_SIMULATE " " RIGID_BODY_SIM_SCENES "/" +
                                             std::string(scene.name) + " " + scene.options +
                                             " --plot " + quoted(out) + " --bag " + bag + " 2>&1");
  ASSERT_EQ(run.exit_code, 0) << run.out;
  EXPECT_EQ(run.out.find("arning"), std::string::npos) << run.out;  // of gnuplot
  std::vector<std::string> expected{"attitude", "balance",  "energy", "momentum",
                                    "position", "velocity", "rates"};
  expected.insert(expected.end(), scene.forces.begin(), scene.forces.end());
  std::sort(expected.begin(), expected.end());
  EXPECT_EQ(pictures(out), expected);
  for (const std::string& name : pictures(out))
    expectDrawn(name, text(out + "/" + name + ".svg"), panelsOf(name));

  const std::string of_bag = files.path("of_bag");
  const test::Outcome again = plot(bag + " --out " + of_bag);
  ASSERT_EQ(again.exit_code, 0) << again.out;
  EXPECT_GE(pictures(of_bag).size(), 4U);
  for (const std::string& name : pictures(of_bag))
    expectDrawn(name, text(of_bag + "/" + name + ".svg"), 3);
}

INSTANTIATE_TEST_SUITE_P(
    Scenes, PlotOfScene,
    ::testing::Values(PlottedScene{"thrown_box.yaml", "", {"force", "torque"}},
                      PlottedScene{"heavy_top.yaml", "--duration 2", {"force", "torque"}},
                      PlottedScene{"landing_box.yaml", "--duration 1", {"force", "torque"}},
                      PlottedScene{"quadrotor.yaml", "--duration 1", {"force"}},
                      PlottedScene{"spring_pair.yaml", "", {"force", "torque"}}),
    [](const ::testing::TestParamInfo<PlottedScene>& scene) {
      const std::string name = scene.param.name;
      return name.substr(0, name.find('.'));
    });

TEST_F(Plot, DrawsTheBodiesThatMoveOrThatAreNamed) {
  std::string rows = kMotionHeader;
  for (const char* t : {"0", "1"}) {
    for (int i = 0; i < 9; ++i)
      rows += std::string(t) + ",body number_" + std::to_string(i) + "," + t +
              ",0,0,0,0,0,1,0,0,0,0,0,0\n";
    rows += std::string(t) + ",ground,0,0,0,0,0,0,1,0,0,0,0,0,0\n";
  }
  const std::string csv = files.written("a run's.csv", rows), out = files.path("out");
  const test::Outcome run = plot("\"" + csv + "\" --out " + out);
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out,
            "plot: notice: the first 8 of 9 bodies that move are drawn; --bodies A,B,... chooses "
            "others\nwrote " +
                out + "/position.svg, attitude.svg, velocity.svg, rates.svg\n");
  const std::string svg = text(out + "/position.svg");
  EXPECT_EQ(curvesIn(svg).size(), 3 * 8U);
  EXPECT_NE(svg.find(">body number_7<"), std::string::npos);  // no subscript
  EXPECT_EQ(svg.find("ground"), std::string::npos);
  EXPECT_EQ(plot("\"" + csv + "\" --bodies 'ground,body number_8' --out " + out).exit_code, 0);
  EXPECT_EQ(curvesIn(text(out + "/position.svg")).size(), 3 * 2U);
  refuses("\"" + csv + "\" --bodies grond", 2,
          "--bodies: the run has no body 'grond'; did you mean 'ground'?; it has body number_0, "
          "body number_1, body number_2, body number_3, body number_4, body number_5, body "
          "number_6, body number_7, body number_8, ground (plot --help)");
}

TEST_F(Plot, DrawsOneRowAsAPoint) {
  const std::string csv =
      files.written("one.csv", kMotionHeader + "0.5,box,1,2,3,0,0,0,1,0,0,0,0,0,0\n");
  const test::Outcome run = plot(csv + " --out " + files.path("."));
  EXPECT_EQ(run.exit_code, 0) << run.out;
  EXPECT_EQ(run.out.find("arning"), std::string::npos) << run.out;
  for (const std::string& curve : curvesIn(text(files.path("position.svg"))))
    EXPECT_NE(curve.find("<use"), std::string::npos) << curve;
}

TEST_F(Plot, SaysOfABodyThatTurnsTooFarBetweenSamples) {
  const std::string rows = "0,box,0,0,0,0,0,0,1,0,0,0,0,0,4\n1,box,0,0,0,0,0,0,1,0,0,0,0,0,4\n";
  const test::Outcome run =
      plot(files.written("run.csv", kMotionHeader + rows) + " --out " + files.path("."));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(
      run.out.find("plot: notice: body 'box' turns more than half a turn between two samples"), 0U)
      << run.out;
}

TEST_F(Plot, RefusesWhatItCannotReadOrWrite) {
  const std::string good =
      files.written("run.csv", kMotionHeader + "0,box,0,0,0,0,0,0,1,0,0,0,0,0,0\n");
  const std::string empty = files.written("empty.csv", "");
  const std::string kinds =
      ": neither a bag (.bag) nor a CSV file that simulate writes with --csv or --plot: line 1 is ";
  refuses(empty, 1, empty + kinds + "''");
  const std::string other = files.written("run.txt", "time\tbody\n");
  refuses(other, 1, other + kinds + "'time?body'");
  const std::string bare = files.written("bare.csv", kMotionHeader);
  refuses(bare, 1, bare + ": holds no rows");
  const std::string cut = files.written("cut.csv", kMotionHeader + "0,box,0,0,0,0,0\n");
  refuses(cut, 1, cut + ": line 2: 15 fields are expected, got 7");
  const std::string nan =
      files.written("nan.csv", kMotionHeader + "0,box,0,nan,0,0,0,0,1,0,0,0,0,0,0\n");
  refuses(nan, 1, nan + ": line 2: a finite number is expected, got 'nan'");
  const std::string turned =
      files.written("turned.csv", kMotionHeader + "0,box,0,0,0,0,0,0,2,0,0,0,0,0,0\n");
  refuses(turned, 1, turned + ": line 2: the norm of the quaternion must be 1, got 2");
  refuses(good + " " + good, 1,
          good + ": another file of the same kind is given, too: plot one run at a time");
  refuses(files.path("."), 1,
          files.path(".") + ": is a directory; plot takes the files in it, by their names");
  refuses(files.path("no.csv"), 1,
          files.path("no.csv") + ": cannot be opened: No such file or directory");
  refuses("", 2, "at least one file is needed, got 0 (plot --help)");
  refuses(good + " --out " + good + "/x", 1, good + "/x: cannot be created: Not a directory");
  std::filesystem::create_directories(files.path("d/position.svg"));
  refuses(good + " --out " + files.path("d"), 1,
          files.path("d") + "/position.svg: cannot be written: Is a directory");
}

TEST_F(Plot, RefusesToOverwriteWhatItReads) {
  const std::string rows = kMotionHeader + "0,box,0,0,0,0,0,0,1,0,0,0,0,0,0\n";
  const std::string input = files.written("velocity.svg", rows);
  refuses(input + " --out " + files.path("."), 2,
          "the picture velocity and a file that is read are the same file, " +
              files.path("./velocity.svg") + ": name another one for the output (plot --help)");
  EXPECT_EQ(text(input), rows);
  EXPECT_EQ(pictures(files.path(".")), (std::vector<std::string>{"velocity"}));
}

TEST_F(Plot, SaysThatRowsRunBackwards) {
  const std::string rows = "2,box,0,0,0,0,0,0,1,0,0,0,0,0,0\n1,box,1,0,0,0,0,0,1,0,0,0,0,0,0\n";
  const test::Outcome run =
      plot(files.written("back.csv", kMotionHeader + rows) + " --out " + files.path("out"));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out.find("plot: notice: rows run backwards in time, first at 1 s: "), 0U)
      << run.out;
}

TEST_F(Plot, LeavesOutALastLineThatWasCutAndSaysSo) {
  const std::string rows = "0,box,0,0,0,0,0,0,1,0,0,0,0,0,0\n1,box,1,0,0,0,0,0,1,0,0,0,0,0,0\n";
  // of 200,box,...,0.25: a number that was cut is a number
  for (const char* last : {"2", "2,box,3,0,0,0,0,0,1,0,0,0,0,0,0.2"}) {
    const std::string csv = files.written("cut.csv", kMotionHeader + rows + last);
    const test::Outcome run = plot(csv + " --bodies box --out " + files.path("out"));
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.out.find("plot: notice: " + csv +
                           ": line 4 does not end: the file was cut there, or is still being "
                           "written; it is not drawn\nwrote "),
              0U)
        << run.out;
  }
}

TEST_F(Plot, DrawsNoLineWhereABodyWasAbsent) {
  std::string rows = kMotionHeader;
  for (int k = 0; k < 4000; ++k) {
    const std::string t = std::to_string(k);
    const auto row = [&](const std::string& body) {
      return t + "," + body + "," + t + ",0,0,0,0,0,1,0,0,0,0,0,0\n";
    };
    if (k < 1000 || k > 1100) rows += row("leaves");
    rows += row("stays");
  }
  const test::Outcome run = plot(files.written("run.csv", rows) + " --out " + files.path("out"));
  ASSERT_EQ(run.exit_code, 0) << run.out;
  const std::vector<std::string> curves = curvesIn(text(files.path("out/position.svg")));
  ASSERT_EQ(curves.size(), 6U);
  EXPECT_EQ(countOf("M", curves[0]), 3U);  // in the legend, before the gap and after it
}

TEST_F(Plot, SaysHowToInstallGnuplot) {
  const std::string csv =
      files.written("run.csv", kMotionHeader + "0,box,0,0,0,0,0,0,1,0,0,0,0,0,0\n");
  const test::Outcome run =
      test::runCommand("PATH=/nonexistent " RIGID_BODY_SIM_PLOT " " + csv + " 2>&1");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(run.out, "plot: gnuplot is not installed: " + csv +
                         " is there, the plot is not (apt install gnuplot-nox)\n");
  const std::string out = files.path("out");
  const test::Outcome simulate =
      test::runCommand("PATH=/nonexistent " RIGID_BODY_SIM_SIMULATE " " RIGID_BODY_SIM_SCENES
                       "/thrown_box.yaml --plot " +
                       out + " 2>&1 >/dev/null");
  EXPECT_EQ(simulate.exit_code, 0);
  EXPECT_NE(simulate.out.find("simulate: notice: gnuplot is not installed: the CSV files in " +
                              out + " are there, the plot is not (apt install gnuplot-nox)\n"),
            std::string::npos)
      << simulate.out;
  for (const char* name : {"motion.csv", "forces.csv", "balance.csv"})
    EXPECT_GT(text(out + "/" + name).size(), 1000U) << name;
}

}  // namespace rigid_body_sim
