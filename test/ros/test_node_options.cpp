#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "ros/options/node_options.hpp"

namespace rigid_body_sim {
namespace {

XmlRpc::XmlRpcValue withScene() {
  XmlRpc::XmlRpcValue parameters;
  parameters["scene_file"] = "top.yaml";
  return parameters;
}

std::string refusalOf(const XmlRpc::XmlRpcValue& parameters) {
  try {
    toNodeOptions(parameters);
  } catch (const ParameterError& error) {
    return error.what();
  }
  return "accepted";
}

template <class T>
std::string refusalOf(const char* name, const T& value) {
  XmlRpc::XmlRpcValue parameters = withScene();
  parameters[name] = value;
  return refusalOf(parameters);
}

}  // namespace

TEST(NodeOptions, AreTheDocumentedDefaults) {
  const NodeOptions options = toNodeOptions(withScene());
  EXPECT_EQ(options.scene_file, "top.yaml");
  EXPECT_EQ(options.publish_rate, 100);
  EXPECT_EQ(options.clock_rate, 100);
  EXPECT_FALSE(options.publish_clock);
  EXPECT_EQ(options.real_time_factor, 1);
  EXPECT_EQ(options.wrench_timeout, 0.5);
  EXPECT_FALSE(options.reset_time);
  EXPECT_FALSE(options.start_paused);
  EXPECT_TRUE(options.body_topics);
  EXPECT_EQ(options.tf_prefix, "");
  EXPECT_EQ(options.odometry_covariance, (std::array<double, 6>{}));
}

TEST(NodeOptions, TakeEveryParameter) {
  XmlRpc::XmlRpcValue parameters;
  parameters["scene"] = "time_step: 1";
  parameters["publish_rate"] = 12.5;
  parameters["clock_rate"] = 50;  // an int where a double is asked
  parameters["publish_clock"] = true;
  parameters["real_time_factor"] = 0;
  parameters["wrench_timeout"] = 0.0;
  parameters["reset_time"] = true;
  parameters["start_paused"] = true;
  parameters["body_topics"] = false;
  parameters["tf_prefix"] = "/robot_1/";
  for (int i = 0; i < 6; ++i) parameters["odometry_covariance"][i] = 0.5 * i;
  const NodeOptions options = toNodeOptions(parameters);
  EXPECT_EQ(options.scene_text, "time_step: 1");
  EXPECT_EQ(options.publish_rate, 12.5);
  EXPECT_EQ(options.clock_rate, 50);
  EXPECT_TRUE(options.publish_clock);
  EXPECT_EQ(options.real_time_factor, 0);
  EXPECT_EQ(options.wrench_timeout, 0);
  EXPECT_TRUE(options.reset_time);
  EXPECT_TRUE(options.start_paused);
  EXPECT_FALSE(options.body_topics);
  EXPECT_EQ(options.tf_prefix, "robot_1");
  EXPECT_EQ(options.odometry_covariance, (std::array<double, 6>{0, 0.5, 1, 1.5, 2, 2.5}));
}

TEST(NodeOptions, TakeOneCovarianceForAllAxes) {
  XmlRpc::XmlRpcValue parameters = withScene();
  parameters["odometry_covariance"] = 0.01;
  EXPECT_EQ(toNodeOptions(parameters).odometry_covariance,
            (std::array<double, 6>{0.01, 0.01, 0.01, 0.01, 0.01, 0.01}));
}

TEST(NodeOptions, NeedExactlyOneScene) {
  XmlRpc::XmlRpcValue both = withScene();
  both["scene"] = "time_step: 1";
  EXPECT_EQ(refusalOf(both), "parameters ~scene_file, ~scene: exactly one must be given, got both");
  EXPECT_EQ(refusalOf(XmlRpc::XmlRpcValue()),
            "parameters ~scene_file, ~scene: exactly one must be given, got neither");
}

TEST(NodeOptions, RefuseAnUnknownName) {
  EXPECT_EQ(
      refusalOf("publish_rat", 10),
      "parameter ~publish_rat: unknown, got '10'; known: body_topics, clock_rate, "
      "command_timeout, diagnostic_period, lockstep, lockstep_period, lockstep_timeout, "
      "odometry_covariance, publish_clock, publish_rate, real_time_factor, reset_time, scene, "
      "scene_file, start_paused, start_time, tf_prefix, wrench_timeout");
}

// diagnostic_updater, within the node, reads it.
TEST(NodeOptions, TakeThePeriodOfDiagnostics) {
  XmlRpc::XmlRpcValue parameters = withScene();
  parameters["diagnostic_period"] = 0.5;
  EXPECT_NO_THROW(toNodeOptions(parameters));
  EXPECT_NE(refusalOf("diagnostic_period", -1).find("parameter ~diagnostic_period: must be"),
            std::string::npos);
}

TEST(NodeOptions, RefuseAWrongType) {
  EXPECT_EQ(refusalOf("publish_rate", "fast"),
            "parameter ~publish_rate: must be a number > 0 and at most 1e9, as stamps are whole "
            "nanoseconds, got 'fast'");
  EXPECT_EQ(refusalOf("start_paused", 1),
            "parameter ~start_paused: must be true or false, got '1'");
  EXPECT_EQ(refusalOf("scene_file", 3),
            "parameter ~scene_file: must be a string that is not empty, got '3'");
  EXPECT_EQ(refusalOf("scene_file", "time_step: 0.1\nbodies:"),
            "parameter ~scene_file: must be a path; the text of a scene goes to ~scene, got "
            "'time_step: 0.1?bodies:'");
  EXPECT_EQ(refusalOf("real_time_factor", true),
            "parameter ~real_time_factor: must be a finite number >= 0, got 'true'");
}

TEST(NodeOptions, RefuseAValueOutsideItsRule) {
  EXPECT_EQ(refusalOf("publish_rate", 0),
            "parameter ~publish_rate: must be a number > 0 and at most 1e9, as stamps are whole "
            "nanoseconds, got '0'");
  for (const double too_fast : {1.01e9, 1.7e308, std::numeric_limits<double>::infinity()})
    EXPECT_NE(refusalOf("publish_rate", too_fast), "accepted") << too_fast;
  EXPECT_EQ(refusalOf("wrench_timeout", -1),
            "parameter ~wrench_timeout: must be a finite number >= 0, got '-1'");
  EXPECT_NE(refusalOf("clock_rate", std::nan("")), "accepted");
  EXPECT_NE(refusalOf("real_time_factor", std::numeric_limits<double>::infinity()), "accepted");
}

TEST(NodeOptions, TakeTopicsAsAListOrAsAText) {
  XmlRpc::XmlRpcValue list = withScene();
  list["lockstep_period"] = 0.02;
  list["lockstep"][0] = "box/command";
  list["lockstep"][1] = "~wrenches";
  XmlRpc::XmlRpcValue text = list;
  text["lockstep"] = "[box/command, ~wrenches]";
  for (const XmlRpc::XmlRpcValue& parameters : {list, text}) {
    const NodeOptions options = toNodeOptions(parameters);
    EXPECT_EQ(options.lockstep, (std::vector<std::string>{"box/command", "~wrenches"}));
    EXPECT_EQ(options.lockstep_period, 0.02);
  }
  XmlRpc::XmlRpcValue none = withScene();
  none["lockstep"] = "";
  EXPECT_TRUE(toNodeOptions(none).lockstep.empty());
}

TEST(NodeOptions, RefuseALockstepThatLacksAPart) {
  EXPECT_EQ(refusalOf("lockstep", "box/command"),
            "parameter ~lockstep: needs ~lockstep_period, > 0 s, which is missing, beside it");
  XmlRpc::XmlRpcValue without_time = withScene();
  without_time["lockstep"] = "box/command";
  without_time["lockstep_period"] = 0;
  EXPECT_EQ(refusalOf(without_time),
            "parameter ~lockstep_period: must be > 0 s where ~lockstep names topics, got '0'");
  EXPECT_EQ(refusalOf("lockstep_period", 0.1),
            "parameter ~lockstep_period: must be 0 unless ~lockstep names topics: nothing would be "
            "waited for, got '0.1'");
  EXPECT_EQ(
      refusalOf("lockstep", "3 boxes"),
      "parameter ~lockstep: must be names of topics, as a list or separated by commas, got '3 "
      "boxes'");
  EXPECT_EQ(refusalOf("lockstep_timeout", -1),
            "parameter ~lockstep_timeout: must be a finite number >= 0, got '-1'");
}

TEST(NodeOptions, SayThatAPathIsNoText) {
  EXPECT_EQ(
      refusalOf("scene", "/tmp/top.yaml"),
      "parameter ~scene: must be the YAML text of a scene; a path belongs in ~scene_file, got "
      "'/tmp/top.yaml'");
}

TEST(NodeOptions, RefuseCovariancesThatAreNone) {
  EXPECT_NE(refusalOf("odometry_covariance", -1), "accepted");
  EXPECT_NE(refusalOf("odometry_covariance", std::nan("")), "accepted");
  XmlRpc::XmlRpcValue five;
  for (int i = 0; i < 5; ++i) five[i] = 1;
  EXPECT_NE(refusalOf("odometry_covariance", five), "accepted");
  five[5] = "1";
  EXPECT_NE(refusalOf("odometry_covariance", five), "accepted");
}

TEST(NodeOptions, RefuseAPrefixThatIsNoName) {
  for (const char* prefix : {"9robots", "a b", "a//b"})
    EXPECT_NE(refusalOf("tf_prefix", prefix), "accepted") << prefix;
  EXPECT_NE(refusalOf("tf_prefix", 1), "accepted");
}

TEST(NodeOptions, SayHowToDeleteWhatAnEarlierStartLeft) {
  const ParameterError error("parameter ~publish_rat: unknown", {"publish_rat"});
  EXPECT_EQ(describe(error, "/a/node", {"scene_file"}),
            "parameter ~publish_rat: unknown; it is on the master, maybe from an earlier start: "
            "rosparam delete /a/node/publish_rat");
  EXPECT_EQ(describe(error, "/a/node", {"publish_rat"}), "parameter ~publish_rat: unknown");
}

struct ClockCase {
  bool publish_clock, use_sim_time;
  void (*set)(NodeOptions&);
  const char* refusal;  // empty: accepted
};

class Clocks : public ::testing::TestWithParam<ClockCase> {};

TEST_P(Clocks, GoTogetherOrAreRefused) {
  NodeOptions options;
  options.publish_clock = GetParam().publish_clock;
  GetParam().set(options);
  std::string refusal;
  try {
    settleClock(options, GetParam().use_sim_time);
    EXPECT_EQ(options.follow_clock, GetParam().use_sim_time && !GetParam().publish_clock);
  } catch (const ParameterError& error) {
    refusal = error.what();
  }
  if (*GetParam().refusal == '\0')
    EXPECT_EQ(refusal, "");
  else
    EXPECT_NE(refusal.find(GetParam().refusal), std::string::npos) << refusal;
}

void nothing(NodeOptions&) {}
void resetTime(NodeOptions& options) { options.reset_time = true; }
void twiceAsFast(NodeOptions& options) { options.real_time_factor = 2; }
void startTime(NodeOptions& options) { options.start_time = 0; }

INSTANTIATE_TEST_SUITE_P(
    NodeOptions, Clocks,
    ::testing::Values(
        ClockCase{false, false, nothing, ""}, ClockCase{false, true, nothing, ""},
        ClockCase{true, true, nothing, ""},
        ClockCase{true, false, nothing, "~publish_clock: must be false unless /use_sim_time is"},
        ClockCase{false, false, resetTime, "~reset_time: must be false unless ~publish_clock"},
        ClockCase{false, true, resetTime, "~reset_time: must be false unless ~publish_clock"},
        ClockCase{true, true, resetTime, ""}, ClockCase{false, false, twiceAsFast, ""},
        ClockCase{false, true, twiceAsFast, "~real_time_factor: must be 1 where ~publish_clock"},
        ClockCase{true, true, twiceAsFast, ""},
        ClockCase{false, false, startTime, "~start_time: must be absent unless /use_sim_time"},
        ClockCase{false, true, startTime, ""},
        ClockCase{true, true, startTime, "~start_time: must be absent unless /use_sim_time"}));

}  // namespace rigid_body_sim
