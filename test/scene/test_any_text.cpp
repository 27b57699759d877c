#include <fstream>
#include <iterator>
#include <random>

#include <gtest/gtest.h>

#include "scene_texts.hpp"

namespace rigid_body_sim {
namespace {

std::string shippedScene(const std::string& name) {
  std::ifstream file(std::string(RIGID_BODY_SIM_SCENES) + "/" + name);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A text damaged in one to four places: bytes replaced, put in, cut out, or a stretch repeated.
std::string damaged(std::string text, std::mt19937& rng) {
  const std::string bytes = std::string(":[]{},-#&*!|>'\"%@`~?<. \n\t\r01e+n\\") + '\0' + '\x80';
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(rng()) % n; };
  for (std::size_t count = 1 + below(4); count > 0; --count) {
    const std::size_t at = below(text.size());
    const std::size_t length = 1 + below(8);
    switch (below(4)) {
      case 0:
        text[at] = bytes[below(bytes.size())];
        break;
      case 1:
        text.insert(at, 1, bytes[below(bytes.size())]);
        break;
      case 2:
        text.erase(at, length);
        break;
      default:
        text.insert(below(text.size()), text.substr(at, 4 * length));
    }
  }
  return text;
}

}  // namespace

TEST(SceneText, OfAnyBytesIsReadOrRefusedInOneLine) {
  std::mt19937 rng(11);
  int refused = 0;
  for (const char* name : {"thrown_box.yaml", "wing_nut.yaml"}) {
    const std::string text = shippedScene(name);
    for (int i = 0; i < 1500; ++i) {
      const std::string error = errorOf(damaged(text, rng));  // any other exception fails the test
      if (error.empty()) continue;
      ++refused;
      ASSERT_EQ(error.substr(0, 6), "s.yaml");
      ASSERT_EQ(error.find_first_of("\n\r"), std::string::npos) << error;
      ASSERT_LT(error.size(), 400U) << error;
    }
  }
  EXPECT_GT(refused, 1000);  // damage in comments does no harm, most other does
}

}  // namespace rigid_body_sim
