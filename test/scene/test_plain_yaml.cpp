#include <array>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "support/yaml_event_list.hpp"

namespace rigid_body_sim {
namespace {

using test::libyamlEvents;
using test::plainEvents;

const std::string kPlain = R"(# many bodies
gravity: [0, 0, -9.81]   # m/s^2
time_step: 1e-3
bodies:
  - {name: a, shape: {box: [1, 2., .5]}, mass: +2, twist: {frame: world, linear: [1, 0, 0,]}}
  - name: b
    mass: 1

    # the inertia
    inertia:
      ixx: 1
      iyy: 1
      izz: 1
    points: {}
    position: [ -1 , -.5, 0 ]
  -
    name: base-link/c_1
    parts:
    - mass: 1
      shape: {sphere: {radius: 1}}
    - mass: 2
    fixed: true
wrenches:
- [[1, null], []]
- 5
)";

/// The text with some of its bytes replaced, doubled or taken out.
std::string changed(std::string text, std::mt19937& random) {
  constexpr std::array<char, 18> bytes = {' ', '\n', ':', '-', ',', '[', ']', '{', '}',
                                          '#', '.',  'a', '1', '"', '~', '&', '?', '\t'};
  for (int edits = 1 + static_cast<int>(random() % 3); edits > 0; --edits) {
    const std::size_t at = random() % text.size();
    const char byte = bytes[random() % bytes.size()];
    switch (random() % 4) {
      case 0:
        text[at] = byte;
        break;
      case 1:
        text.insert(at, 1, byte);
        break;
      case 2:
        text.erase(at, 1 + random() % 4);
        break;
      default:
        text.insert(random() % text.size(), text.substr(at, random() % 40));
    }
  }
  return text;
}

}  // namespace

TEST(PlainYaml, GivesTheEventsOfLibyaml) {
  ASSERT_TRUE(plainEvents(kPlain));
  EXPECT_EQ(*plainEvents(kPlain), libyamlEvents(kPlain));
}

TEST(PlainYaml, GivesThemOfEveryTextThatItTakes) {
  std::mt19937 random(20);
  int taken = 0;
  for (int i = 0; i < 6000; ++i) {
    const std::string text = changed(kPlain, random);
    const auto events = plainEvents(text);
    if (!events) continue;
    ++taken;
    ASSERT_EQ(*events, libyamlEvents(text)) << text;
  }
  EXPECT_GT(taken, 300);
  EXPECT_LT(taken, 3000);
}

TEST(PlainYaml, LeavesTheRestToLibyaml) {
  for (const char* text : {"",
                           "# nothing",
                           "a",
                           "[1]",
                           "{a: 1}",
                           "a:\n",
                           "a: \nb: 1\n",
                           "- \n",
                           "a: 'b'\n",
                           "a: \"b\"\n",
                           "a: |\n  b\n",
                           "a: b c\n",
                           "a: 1\n  2\n",
                           "a: 1 2\n",
                           "a: [1,\n  2]\n",
                           "a: {b}\n",
                           "a: {b:1}\n",
                           "a: [b: 1]\n",
                           "a: &b 1\n",
                           "a: *b\n",
                           "a: !b 1\n",
                           "? a\n: 1\n",
                           "a : 1\n",
                           "a:1\n",
                           "- - 1\n",
                           "a: - 1\n",
                           "---\na: 1\n",
                           "a: 1\n...\n",
                           "%YAML 1.1\n",
                           "a: 1 #\t\n",
                           "a: 1#b\n",
                           "a:\t1\n",
                           "a: 1\r\n",
                           "a: \xc3\xa4\n",
                           " a: 1\nb: 1\n",
                           "a: 1\n b: 1\n",
                           "- 1\na: 1\n",
                           "a: 1\n- 1\n",
                           "- a: 1\n   b: 1\n",
                           "a: [[1]\n",
                           "a: [1]]\n",
                           "a: [,]\n",
                           "a: [1}\n"})
    EXPECT_FALSE(plainEvents(text)) << text;
}

}  // namespace rigid_body_sim
