#include <string>

#include <gtest/gtest.h>

#include "support/run_command.hpp"

namespace rigid_body_sim {

struct Program {
  const char* name;
  const char* path;
};

class Help : public ::testing::TestWithParam<Program> {};

void expectHelpWithoutAMaster(const Program& program) {
  // both streams: nothing but the help is said
  const test::Outcome run = test::runCommand(std::string("ROS_MASTER_URI=http://localhost:1 ") +
                                             program.path + " --help 2>&1");
  EXPECT_EQ(run.exit_code, 0);
  EXPECT_EQ(run.out.find("usage: "), 0U) << run.out;
  EXPECT_NE(run.out.substr(0, run.out.find('\n')).find(program.name), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("--help"), std::string::npos) << run.out;
}

TEST_P(Help, IsGivenByEveryProgramWithoutAMaster) { expectHelpWithoutAMaster(GetParam()); }

TEST(HelpOfExamples, IsGivenWithoutAMaster) {
  expectHelpWithoutAMaster({"drone_pilot", RIGID_BODY_SIM_DRONE_PILOT});
}

TEST_P(Help, ThatCannotBeWrittenIsNoSuccess) {
  for (const char* output : {">/dev/full", ">&-"}) {
    const test::Outcome run =
        test::runCommand("exec 3>&1; " + std::string(GetParam().path) + " --help 2>&3 " + output);
    EXPECT_EQ(run.exit_code, 1) << output;
    EXPECT_EQ(run.out.find(std::string(GetParam().name) + ": standard output cannot be written: "),
              0U)
        << run.out;
  }
}

INSTANTIATE_TEST_SUITE_P(Programs, Help,
                         ::testing::Values(Program{"compare_runs", RIGID_BODY_SIM_COMPARE_RUNS},
                                           Program{"demo_pusher", RIGID_BODY_SIM_DEMO_PUSHER},
                                           Program{"mass_properties",
                                                   RIGID_BODY_SIM_MASS_PROPERTIES},
                                           Program{"plot", RIGID_BODY_SIM_PLOT},
                                           Program{"rigid_body_node", RIGID_BODY_SIM_NODE},
                                           Program{"simulate", RIGID_BODY_SIM_SIMULATE},
                                           Program{"sweep", RIGID_BODY_SIM_SWEEP},
                                           Program{"trade", RIGID_BODY_SIM_TRADE}),
                         [](const ::testing::TestParamInfo<Program>& program) {
                           return std::string(program.param.name);
                         });

}  // namespace rigid_body_sim
