#include <algorithm>
#include <limits>
#include <random>
#include <utility>

#include <gtest/gtest.h>

#include <rigid_body_sim/mass/shapes.hpp>

#include "dynamics/contact/overlapping_spheres.hpp"
#include "support/contact_benches.hpp"

/// Many bodies, of which each may touch each.
namespace rigid_body_sim {
namespace {

using test::Bench;
using test::contactOf;
using test::motionAt;

using Pairs = std::vector<std::pair<std::size_t, std::size_t>>;

Pairs overlapsOneByOne(const std::vector<BoundingSphere>& spheres) {
  Pairs pairs;
  for (std::size_t a = 0; a < spheres.size(); ++a)
    for (std::size_t b = a + 1; b < spheres.size(); ++b)
      if (spheres[a].radius >= 0 && spheres[b].radius >= 0 &&
          (spheres[a].center - spheres[b].center).norm() <= spheres[a].radius + spheres[b].radius)
        pairs.emplace_back(a, b);
  return pairs;
}

TEST(OverlappingSpheres, AreThoseFoundOneByOne) {
  std::mt19937 random(41);
  std::uniform_real_distribution<double> place(-5, 5), size(-0.2, 1.5);
  std::size_t found = 0;
  for (int round = 0; round < 50; ++round) {
    std::vector<BoundingSphere> spheres;
    for (int i = 0; i < 60; ++i)
      spheres.push_back({{place(random), 0.3 * place(random), place(random)}, size(random)});
    spheres[7].radius = std::numeric_limits<double>::infinity();
    spheres[9].center = spheres[8].center;
    const Pairs pairs = overlappingSpheres(spheres);
    EXPECT_EQ(pairs, overlapsOneByOne(spheres));
    found += pairs.size();
  }
  EXPECT_GT(found, 1000U);
  EXPECT_TRUE(overlappingSpheres({}).empty());
}

TEST(OverlappingSpheres, TouchExactlyFarFromTheOrigin) {
  EXPECT_EQ(overlappingSpheres({{{1e6, 0, 0}, 0.25}, {{1e6 + 0.75, 0, 0}, 0.5}}), (Pairs{{0, 1}}));
  EXPECT_TRUE(overlappingSpheres({{{1e6, 0, 0}, 0.25}, {{1e6 + 0.76, 0, 0}, 0.5}}).empty());
}

/// Contact of two balls of 0.1 m that counts how often it is looked at.
class CountedContact final : public ForceLaw {
 public:
  CountedContact(std::shared_ptr<const ForceLaw> contact, std::int64_t& looks)
      : contact_(std::move(contact)), looks_(looks) {}

  const char* name() const override { return contact_->name(); }
  std::vector<std::size_t> members() const override { return contact_->members(); }
  std::shared_ptr<const ForceLaw> reindexed(
      const std::function<std::size_t(std::size_t)>& index) const override {
    return std::make_shared<CountedContact>(contact_->reindexed(index), looks_);
  }
  unsigned needs() const override { return contact_->needs(); }
  void addWrenches(const Bodies& at, std::vector<Wrench>& wrenches) const override {
    contact_->addWrenches(at, wrenches);
  }
  double potentialEnergy(const Bodies& at) const override { return contact_->potentialEnergy(at); }
  double externalPower(const Bodies& at) const override { return contact_->externalPower(at); }
  double rate(const Bodies& at, const std::vector<double>& speeds) const override {
    return contact_->rate(at, speeds);
  }
  bool hasRate() const override { return true; }
  std::size_t stateCount() const override { return contact_->stateCount(); }
  void setRates(const Bodies& at, double* rates) const override { contact_->setRates(at, rates); }
  std::size_t guardCount() const override { return contact_->guardCount(); }
  void setGuards(const Bodies& at, double* guards) const override {
    ++looks_;
    contact_->setGuards(at, guards);
  }
  void switchMode(std::size_t guard, const Bodies& at, double* own) const override {
    contact_->switchMode(guard, at, own);
  }
  bool acts(const double* own) const override { return contact_->acts(own); }
  double quietInFlight(double t, const Bodies& at,
                       const std::vector<MotionBound>& bounds) const override {
    ++looks_;
    return contact_->quietInFlight(t, at, bounds);
  }
  bool isOneSided() const override { return true; }
  bool switchesSmoothly() const override { return true; }
  double touchRadius(std::size_t k) const override { return contact_->touchRadius(k); }
  bool holdsStill(const Bodies& at, const std::vector<Stray>& strays) const override {
    ++looks_;
    return contact_->holdsStill(at, strays);
  }

 private:
  std::shared_ptr<const ForceLaw> contact_;
  std::int64_t& looks_;
};

void addAllPairs(Bench& bench, std::int64_t& looks) {
  const std::size_t count = bench.world.bodies.size();
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = a + 1; b < count; ++b)
      bench.world.laws.push_back(std::make_shared<CountedContact>(
          contactOfBalls(bench.world.bodies, a, test::ballShape(0.1), b, test::ballShape(0.1),
                         contactOf(1e5, 1.5, 1, 0)),
          looks));
}

/// Per step and ball, over a second, of balls that bounce on a plane, `apart` [m] from one another.
double looksAtPairs(std::size_t count, double apart) {
  Bench bench;
  bench.world.g_W = {0, 0, -9.80665};
  for (std::size_t i = 0; i < count; ++i)
    test::addBall(bench, 0.1, 1,
                  motionAt({apart * static_cast<double>(i % 8), apart * static_cast<double>(i / 8),
                            0.2 + 0.001 * static_cast<double>(i)}),
                  test::slope(0), contactOf(1e5, 1.5, 1, 0));
  std::int64_t looks = 0;
  addAllPairs(bench, looks);
  Simulation sim = test::simulationAt(bench, 1e-6, 0.01);
  looks = 0;  // at the start, all are looked at
  for (int i = 0; i < 100; ++i) sim.step();
  return static_cast<double>(looks) / (100 * static_cast<double>(count));
}

// Looked at one by one, they would be seen 15 times; now it is as they are found, from the spheres
// that hold their flights.
TEST(Pairs, AreHardlyLookedAtWhileTheyAreFarApart) { EXPECT_LT(looksAtPairs(32, 5), 0.5); }

// Of 32 and of 64 balls in rows of eight, close together: the neighbours of a ball are as many, but
// for the edge. One by one, the pairs would be four times as many.
TEST(Pairs, GrowWithTheBodiesNotWithTheirSquare) {
  const double few = 32 * looksAtPairs(32, 0.22), many = 64 * looksAtPairs(64, 0.22);
  EXPECT_GT(few, 1);
  EXPECT_LT(many, 3.5 * few);
}

/// A heavy ball strikes a light one, which flies off at nearly twice its speed and strikes a third.
Bench threeInARow() {
  Bench bench;
  test::addBall(bench, 0.1, 50, motionAt({-0.25, 0, 5}, {2, 0, 0}), test::slope(0),
                contactOf(1e5, 1.5, 0, 0));
  test::addBall(bench, 0.1, 0.1, motionAt({0, 0, 5}), test::slope(0), contactOf(1e5, 1.5, 0, 0));
  test::addBall(bench, 0.1, 1, motionAt({0.4, 0.02, 5}), test::slope(0), contactOf(1e5, 1.5, 0, 0));
  for (const auto& [a, b] : Pairs{{0, 1}, {0, 2}, {1, 2}})
    bench.world.laws.push_back(contactOfBalls(bench.world.bodies, a, test::ballShape(0.1), b,
                                              test::ballShape(0.1), contactOf(1e5, 1.5, 0, 0)));
  return bench;
}

// Both impacts lie within one long step, and nothing at its start tells of the second one.
TEST(Pairs, AreFoundOfABodyThatIsStruckWithinTheStep) {
  Simulation coarse = test::simulationAt(threeInARow(), 1e-9, 0.2);
  Simulation fine = test::simulationAt(threeInARow(), 1e-9, 0.001);
  int touches = 0;
  while (coarse.steps() < 1) coarse.step();
  for (const ContactEvent& event : coarse.contactEvents()) touches += event.touch;
  while (fine.steps() < 200) fine.step();
  EXPECT_GE(touches, 2);
  for (std::size_t body = 0; body < 3; ++body)
    EXPECT_LT(distanceBetween(coarse.body(body), fine.body(body)), 1e-8) << body;
  EXPECT_GT(fine.body(2).p_W.norm(), 0.1);
}

// A spring drives one ball from rest into the other, within one long step: nothing at its start
// tells how fast it will be.
TEST(Pairs, AreFoundOfABodyThatASpringDrives) {
  Bench bench;
  for (double x : {-0.3, 0.1})
    bench.add(makeBody("ball", massProperties(Sphere{0.1}, 1)), motionAt({x, 0.05 * x, 0}));
  bench.world.laws.push_back(contactOfBalls(bench.world.bodies, 0, test::ballShape(0.1), 1,
                                            test::ballShape(0.1), contactOf(1e5, 1.5, 0, 0)));
  bench.addSpring({0, {0, 0, 0}}, {kWorld, {0.5, 0, 0}}, {400, 0, 0});
  Simulation coarse = test::simulationAt(bench, 1e-9, 0.2);
  Simulation fine = test::simulationAt(bench, 1e-9, 0.001);
  coarse.step();
  while (fine.steps() < 200) fine.step();
  EXPECT_EQ(coarse.contactEvents().size(), 2u);
  for (std::size_t body = 0; body < 2; ++body)
    EXPECT_LT(distanceBetween(coarse.body(body), fine.body(body)), 1e-8) << body;
  EXPECT_GT(fine.body(1).p_W.norm(), 1);
}

}  // namespace
}  // namespace rigid_body_sim
