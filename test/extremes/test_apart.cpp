#include <csignal>
#include <cstdlib>
#include <iostream>
#include <stdexcept>

#include <gtest/gtest.h>

#include "apart.hpp"

namespace rigid_body_sim::extremes {
namespace {

constexpr int kLimit = 1;  // [s]

TEST(Apart, WorkReturnsItsResult) {
  const Outcome outcome = doneApart([] { return std::string("a\0b", 3); }, kLimit);
  EXPECT_EQ(outcome.result, std::string("a\0b", 3));
  EXPECT_EQ(outcome.fate, "");
}

TEST(Apart, WhatEndsWorkIsReported) {
  EXPECT_EQ(doneApart([]() -> std::string { std::abort(); }, kLimit).fate, "aborts");
  EXPECT_EQ(doneApart([]() -> std::string { std::_Exit(0); }, kLimit).fate, "exits");
  const auto crashing = []() -> std::string {
    std::signal(SIGSEGV, SIG_DFL);  // a sanitizer would exit
    std::raise(SIGSEGV);
    return "";
  };
  EXPECT_EQ(doneApart(crashing, kLimit).fate, "crashes");
}

TEST(Apart, WorkThatTakesTooLongIsEnded) {
  const auto endless = []() -> std::string {
    for (volatile bool forever = true; forever;) {
    }
    return "";
  };
  EXPECT_EQ(doneApart(endless, kLimit).fate, "over 1 s");
}

TEST(Apart, WhatWorkPrintsIsReturned) {
  const Outcome outcome = doneApart(
      []() -> std::string {
        std::cerr << "first" << std::endl;
        throw std::runtime_error("then");
      },
      kLimit);
  EXPECT_EQ(outcome.fate, "throws");
  EXPECT_EQ(outcome.said, "first\nthen\n");
}

}  // namespace
}  // namespace rigid_body_sim::extremes
