#include <set>

#include <gtest/gtest.h>

#include "ros/mouse/menu.hpp"

namespace rigid_body_sim {

TEST(Menu, OffersEachChoiceOnceUnderAnIdOfItsOwn) {
  std::set<std::uint32_t> ids;
  std::set<std::string> titles;
  for (const visualization_msgs::MenuEntry& entry : menuEntries()) {
    ids.insert(entry.id);
    titles.insert(entry.title);
    EXPECT_EQ(entry.parent_id, 0U);
    EXPECT_EQ(entry.command_type, visualization_msgs::MenuEntry::FEEDBACK);
  }
  EXPECT_EQ(ids.size(), menuEntries().size());
  EXPECT_EQ(titles.size(), menuEntries().size());
  EXPECT_EQ(ids.count(0), 0U);  // which is no entry
  EXPECT_EQ(*ids.rbegin(), static_cast<std::uint32_t>(MenuChoice::kStopFollowing));
}

TEST(Menu, HalvesAndDoublesThePaceAsFarAsThatMakesSense) {
  EXPECT_EQ(slowerFactor(1), 0.5);
  EXPECT_EQ(fasterFactor(1), 2);
  EXPECT_EQ(slowerFactor(0), 1);  // as fast as possible
  EXPECT_EQ(fasterFactor(0), 0);
  EXPECT_EQ(fasterFactor(1024), 0);
  EXPECT_EQ(slowerFactor(1.0 / 1024), 1.0 / 1024);
}

}  // namespace rigid_body_sim
