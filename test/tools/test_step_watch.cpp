#include <future>
#include <string>

#include <gtest/gtest.h>

#include "programs/step_watch.hpp"

namespace rigid_body_sim {
namespace {

/// What is said of a step that never ends.
std::string saidOf(double t) {
  std::promise<std::string> said;
  StepWatch watch([&](const std::string& text) { said.set_value(text); }, 0.01);
  watch.begin(0);
  watch.begin(t);
  return said.get_future().get();
}

}  // namespace

TEST(StepWatch, SaysWhichStepDoesNotEnd) {
  EXPECT_EQ(saidOf(0.25),
            "0.01 s have not ended the step from t = 0.25 s: something is far faster "
            "than the time_step; if it cannot be followed, a line will say what");
}

TEST(StepWatch, SaysThatTheRunHasNotBegun) {
  EXPECT_EQ(saidOf(StepWatch::kBeforeTheRun),
            "0.01 s have not led to the first step: files are large, integrators are "
            "tried on a fast motion, or the processor is busy");
}

}  // namespace rigid_body_sim
