#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

namespace rigid_body_sim {
namespace {

/// All files that start suites, one after the other.
std::string startingFiles() {
  std::ostringstream text;
  for (const auto& entry : std::filesystem::directory_iterator(RIGID_BODY_SIM_ROSTESTS))
    if (entry.path().extension() == ".test") text << std::ifstream(entry.path()).rdbuf();
  return text.str();
}

}  // namespace

TEST(RosTests, AreEachStartedByAFile) {
  const std::string files = startingFiles();
  const testing::UnitTest& all = *testing::UnitTest::GetInstance();
  for (int i = 0; i < all.total_test_suite_count(); ++i) {
    const std::string suite = all.GetTestSuite(i)->name();
    const std::size_t instance = suite.find('/');
    const std::string filter =
        instance == std::string::npos ? suite + ".*" : "*" + suite.substr(instance) + ".*";
    EXPECT_NE(files.find(filter), std::string::npos) << filter << " is in no *.test";
  }
}

}  // namespace rigid_body_sim
