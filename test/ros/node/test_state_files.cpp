#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <ros/service.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <rigid_body_sim/StateFile.h>

#include "support/temporary_directory.hpp"

namespace rigid_body_sim {
namespace {

const std::string kRobot =
    "<robot name='r'><link name='base'><inertial><mass value='1'/><inertia ixx='1' iyy='1' "
    "izz='1' ixy='0' ixz='0' iyz='0'/></inertial></link></robot>";
const std::string kRobotScene = "time_step: 0.01\nbodies: [{name: robot, urdf: {file: r.urdf}}]\n";

/// A node of its own, whose scene may be lost.
class NodeStateFiles : public ::testing::Test {
 protected:
  NodeStateFiles() {
    files.written("r.urdf", kRobot);
    const std::string scene = files.written("s.yaml", kRobotScene);
    child_ = fork();
    if (child_ == 0) {
      execl(RIGID_BODY_SIM_NODE, "rigid_body_node", "__name:=state_files",
            ("_scene_file:=" + scene).c_str(), static_cast<char*>(nullptr));
      _exit(127);
    }
  }

  ~NodeStateFiles() override {
    kill(child_, SIGINT);
    int status = 0;
    waitpid(child_, &status, 0);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  }

  void SetUp() override { ASSERT_TRUE(ros::service::waitForService("state_files/load", 20000)); }

  /// What the service answers, after the path; its success is that it says when.
  std::string answer(const char* service, const std::string& name) const {
    StateFile call;
    call.request.path = files.path(name);
    EXPECT_TRUE(ros::service::call(std::string("state_files/") + service, call));
    const std::string message = call.response.message;
    EXPECT_EQ(call.response.success, message.find("the state at ") != std::string::npos) << message;
    const std::string place = call.request.path + ": ";
    return message.compare(0, place.size(), place) == 0 ? message.substr(place.size()) : message;
  }

  std::string content(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(files.path(name)).rdbuf();
    return text.str();
  }

  TemporaryDirectory files;

 private:
  pid_t child_ = 0;
};

}  // namespace

TEST_F(NodeStateFiles, DoNotReplaceWhatTheSceneWasReadFrom) {
  std::filesystem::create_symlink(files.path("s.yaml"), files.path("link"));
  std::filesystem::create_hard_link(files.path("r.urdf"), files.path("hard"));
  for (const char* name : {"s.yaml", "link"})
    EXPECT_EQ(answer("save", name), "~save and the scene are the same file, " + files.path(name) +
                                        ": name another one for the output");
  for (const char* name : {"r.urdf", "hard"})
    EXPECT_EQ(answer("save", name), "~save and a file that the scene names are the same file, " +
                                        files.path(name) + ": name another one for the output");
  EXPECT_EQ(content("s.yaml"), kRobotScene);
  EXPECT_EQ(content("r.urdf"), kRobot);
}

// What nobody writes or reads at the other end of a pipe would be waited for while time stands.
TEST_F(NodeStateFiles, AreRegularFiles) {
  ASSERT_EQ(mkfifo(files.path("pipe").c_str(), 0600), 0);
  std::filesystem::create_directory(files.path("directory"));
  std::filesystem::create_symlink("/dev/null", files.path("device"));
  std::filesystem::create_symlink(files.path("pipe"), files.path("link to pipe"));
  for (const char* service : {"save", "load"})
    for (const char* name : {"pipe", "directory", "device", "link to pipe"})
      EXPECT_EQ(answer(service, name), "must be a regular file") << service << " " << name;
  files.written("regular", "");
  std::filesystem::create_symlink(files.path("regular"), files.path("link"));
  EXPECT_EQ(answer("save", "link").find("the state at "), 0U);
  EXPECT_EQ(answer("load", "regular").find("on from the state at "), 0U);
  EXPECT_TRUE(std::filesystem::is_symlink(files.path("link")));
}

TEST_F(NodeStateFiles, AnswerInOneLineWhateverTheirNames) {
  for (const char* service : {"save", "load"})
    for (const char* name : {"two\nlines", "no/such\nplace"})
      EXPECT_EQ(answer(service, name).find('\n'), std::string::npos) << service << " " << name;
  EXPECT_TRUE(std::filesystem::exists(files.path("two\nlines")));
}

}  // namespace rigid_body_sim
