#include <filesystem>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nav_msgs/Odometry.h>
#include <rosbag/bag.h>

#include "support/run_command.hpp"
#include "support/temporary_directory.hpp"

namespace rigid_body_sim {
namespace {

class CompareRuns : public ::testing::Test {
 protected:
  test::Outcome compare(const std::string& arguments) const {
    return test::runCommand(RIGID_BODY_SIM_COMPARE_RUNS " " + arguments + " 2>&1");
  }

  /// A CSV file of a body at x [m], turned by 2 asin(qz) about z, at two instants.
  std::string csv(const std::string& name, const std::string& x, const std::string& q) const {
    return files.written(name,
                         "time,body,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz\n"
                         "0,box,0,0,0,0,0,0,1,0,0,0,0,0,0\n"
                         "0.1,box," +
                             x + ",0,0," + q + ",0,2,0,0,0,3\n");
  }

  /// A bag of odometry of `box` at x [m], twice, a second apart from `start` on.
  std::string bag(const std::string& name, double x, const ros::Time& start) const {
    rosbag::Bag bag(files.path(name), rosbag::bagmode::Write);
    for (int i = 0; i < 2; ++i) {
      nav_msgs::Odometry odometry;
      odometry.header.stamp = start + ros::Duration(i);
      odometry.child_frame_id = "box";
      odometry.pose.pose.position.x = i * x;
      odometry.pose.pose.orientation.w = 1;
      bag.write("/box/odom", odometry.header.stamp, odometry);
    }
    return files.path(name);
  }

  /// A bag of odometry of `box` at each x [m], at stamps [s], in the order in which it
  /// is recorded, under a simulation clock.
  std::string record(const std::string& name,
                     const std::vector<std::pair<double, double>>& stamps_and_x) const {
    rosbag::Bag bag(files.path(name), rosbag::bagmode::Write);
    for (const auto& [stamp, x] : stamps_and_x) {
      nav_msgs::Odometry odometry;
      odometry.header.stamp = ros::Time(stamp);
      odometry.child_frame_id = "box";
      odometry.pose.pose.position.x = x;
      odometry.pose.pose.orientation.w = 1;
      bag.write("/box/odom", odometry.header.stamp, odometry);
    }
    return files.path(name);
  }

  TemporaryDirectory files;
};

}  // namespace

TEST_F(CompareRuns, FindsTheSameBits) {
  const std::string a = csv("a.csv", "0.3", "0,0,0,1"), b = csv("b.csv", "0.3", "0,0,0,1");
  const test::Outcome run = compare(a + " " + b);
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out, "box: 2 instants in both, 0 in one only: the same bits\n");
  const std::string first = bag("a.bag", 5, ros::Time(7)), second = bag("b.bag", 5, ros::Time(7));
  EXPECT_EQ(compare(first + " " + second).out, run.out);
}

TEST_F(CompareRuns, MeasuresWhatDiffers) {
  const std::string a = csv("a.csv", "0.3", "0,0,0,1");
  const std::string b = csv("b.csv", "0.3000001", "0,0,0.6,0.8");
  const test::Outcome run = compare(a + " " + b);
  EXPECT_EQ(run.exit_code, 1);
  // 2 asin 0.6 = 1.287 rad
  EXPECT_EQ(run.out,
            "box: 2 instants in both, 0 in one only: position 1e-07 m, attitude 1.3 rad, velocity "
            "0 m/s, angular velocity 0 rad/s; first at 0.100000000 s\n"
            "compare_runs: the runs differ\n");
  EXPECT_EQ(compare(a + " " + b + " --tolerance 1.3").exit_code, 0);
  EXPECT_EQ(compare(a + " " + b + " --tolerance 1.2").exit_code, 1);
  // a difference below what is printed is one, too
  const std::string c = csv("c.csv", "0.30000000000000004", "0,0,0,1");
  EXPECT_EQ(compare(a + " " + c).exit_code, 1);
  // and so is one whose square is below the least double
  const std::string d = csv("d.csv", "0", "0,0,0,1"), e = csv("e.csv", "1e-300", "0,0,0,1");
  EXPECT_EQ(compare(d + " " + e).exit_code, 1);
  EXPECT_EQ(compare(d + " " + e + " --tolerance 1e-9").exit_code, 0);
}

TEST_F(CompareRuns, SaysWhereOnlyBitsDiffer) {
  const std::string a = csv("a.csv", "0", "0,0,0.6,0.8");
  for (const auto& [x, q] : {std::pair<std::string, std::string>{"0", "-0,-0,-0.6,-0.8"},
                             {"-0", "0,0,0.6,0.8"},
                             {"0", "-0,0,0.6,0.8"}}) {
    const std::string b = csv("b.csv", x, q);
    const test::Outcome run = compare(a + " " + b);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(
        run.out,
        "box: 2 instants in both, 0 in one only: only bits differ, as those of 0 and -0 or of "
        "q and -q, the same attitude; first at 0.100000000 s\n"
        "compare_runs: the runs differ in bits alone; --tolerance X compares their motion\n");
    EXPECT_EQ(compare(a + " " + b + " --tolerance 1e-300").exit_code, 0) << x << " " << q;
  }
  // what is small is more than bits
  const test::Outcome small = compare(a + " " + csv("b.csv", "1e-300", "0,0,0.6,0.8"));
  EXPECT_NE(small.out.find("position 1e-300 m"), std::string::npos) << small.out;
}

TEST_F(CompareRuns, ReadsLinesThatEndAsThoseOfWindows) {
  const std::string a = csv("a.csv", "0.3", "0,0,0,1");
  std::string windows;
  for (const char c : test::runCommand("cat " + a).out)
    windows += c == '\n' ? "\r\n" : std::string(1, c);
  const test::Outcome run = compare(a + " " + files.written("windows.csv", windows));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out, "box: 2 instants in both, 0 in one only: the same bits\n");
}

TEST_F(CompareRuns, RefusesWhatIsNoMotion) {
  const std::string a = csv("a.csv", "0.3", "0,0,0,1"), none = csv("none.csv", "0.3", "0,0,0,0");
  const std::string fault = ": the norm of the quaternion must be 1, got 0\n";
  for (const char* options : {"", " --tolerance 10"}) {
    const test::Outcome run = compare(a + " " + none + options);
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.out, "compare_runs: " + none + ": line 3" + fault);
  }
  nav_msgs::Odometry odometry;
  odometry.header.stamp = ros::Time(7);
  odometry.child_frame_id = "box";
  const auto refused = [&](const std::string& line) {
    rosbag::Bag(files.path("none.bag"), rosbag::bagmode::Write)
        .write("/box/odom", odometry.header.stamp, odometry);
    const test::Outcome run =
        compare(bag("a.bag", 5, ros::Time(7)) + " " + files.path("none.bag") + " --tolerance 10");
    EXPECT_EQ(run.exit_code, 1);
    EXPECT_EQ(run.out, "compare_runs: " + files.path("none.bag") + ": /box/odom" + line);
  };
  refused(fault);
  odometry.pose.pose.orientation.w = 1;
  odometry.twist.twist.linear.x = std::numeric_limits<double>::quiet_NaN();
  refused(": position or velocity is not finite\n");
}

// A node that is paused says again where a body is; between, the body was put elsewhere.
TEST_F(CompareRuns, TakesAnyOfTheStatesOfOneInstant) {
  const std::string set = record("set.bag", {{1, 5}, {2, 6}, {2, 6}, {2, 9}, {2, 9}, {3, 10}});
  const std::string line =
      "box: 3 instants in both (at 1 of them a run holds several states, of which the nearest "
      "counts), 0 in one only: ";
  for (const double shown : {6, 9}) {
    const std::string again = record("again.bag", {{1, 5}, {2, shown}, {3, 10}});
    for (const std::string& pair : {set + " " + again, again + " " + set}) {
      const test::Outcome run = compare(pair);
      EXPECT_EQ(run.exit_code, 0) << run.out;
      EXPECT_EQ(run.out, line + "the same bits\n");
    }
  }
  // what neither of them is still differs, and so does what follows
  const test::Outcome other = compare(set + " " + record("other.bag", {{1, 5}, {2, 7}, {3, 10}}));
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_EQ(other.out.find(line + "position 1 m, "), 0U) << other.out;
  EXPECT_EQ(compare(set + " " + record("other.bag", {{1, 5}, {2, 6}, {3, 7}})).exit_code, 1);
}

TEST_F(CompareRuns, TakesTheLastOfSeveralRunsInABag) {
  const std::string two = record("two.bag", {{1, 5}, {2, 6}, {3, 7}, {1, 5}, {2, 8}});
  const test::Outcome run = compare(two + " " + record("one.bag", {{1, 5}, {2, 8}}));
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out, "compare_runs: notice: " + two +
                         ": holds several runs, separated by resets or loads, of which the last is "
                         "compared\nbox: 2 instants in both, 0 in one only: the same bits\n");
}

TEST_F(CompareRuns, NamesTheBodiesOfOneRunOnly) {
  const std::string row = ",0,0,0,0,0,0,1,0,0,0,0,0,0\n";
  const std::string header = "time,body,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz\n";
  const std::string a = files.written("a.csv", header + "0,box" + row);
  const std::string b = files.written("b.csv", header + "0,box" + row + "0,top" + row);
  const std::string c = files.written("c.csv", header + "0,top" + row);
  const test::Outcome run = compare(a + " " + b);
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out,
            "box: 1 instants in both, 0 in one only: the same bits\n"
            "top: in one of the runs only, not compared\n");
  EXPECT_EQ(compare(a + " " + c).out,
            "compare_runs: no body in common: the first run holds 'box', the second 'top'\n");
}

TEST_F(CompareRuns, RefusesWhatCannotBeCompared) {
  const std::string a = csv("a.csv", "0.3", "0,0,0,1");
  const std::string early = bag("a.bag", 1, ros::Time(7)), late = bag("b.bag", 1, ros::Time(90));
  const auto refused = [&](const std::string& arguments, int code, const std::string& line) {
    const test::Outcome run = compare(arguments);
    EXPECT_EQ(run.exit_code, code) << arguments;
    EXPECT_EQ(run.out, "compare_runs: " + line + "\n");
  };
  refused(early + " " + late, 1,
          "body 'box': no instant in common: the first run holds 7.000000000 to 8.000000000 s, the "
          "second 90.000000000 to 91.000000000 s");
  refused(a + " " + early, 2,
          "a bag and a CSV file cannot be compared: their velocities have other axes "
          "(compare_runs --help)");
  refused(a, 2, "exactly two files are needed, got 1 (compare_runs --help)");
  refused(a + " no.csv", 1,
          "no.csv: cannot be opened: No such file or directory (looked for in " +
              std::filesystem::current_path().string() + ")");
  const std::string broken =
      files.written("broken.csv",
                    "time,body,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz\n0,box,0,nan,0,0,0,0,1,0,0,0,"
                    "0,0,0\n");
  refused(a + " " + broken, 1, broken + ": line 2: a finite number is expected, got 'nan'");
  const std::string cut =
      files.written("cut.csv",
                    "time,body,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz\n0,box,0,0,0,0,0,0,1,0,0,0,0,"
                    "0,0\n0.1,box,0,0,0,0,0,0,1,0,0,0,0,0,0.3");
  refused(a + " " + cut, 1,
          cut +
              ": line 3 does not end: the file was cut there, or is still being written; a run is "
              "compared as a whole");
  const std::string text = files.written("x.csv", "hello\n");
  refused(a + " " + text, 1,
          text +
              ": neither a bag (.bag) nor a CSV file of simulate: line 1 must be "
              "time,body,px,py,pz,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz");
}

}  // namespace rigid_body_sim
