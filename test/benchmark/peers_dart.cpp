#include <memory>

#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/simulation/World.hpp>

#include "benchmark/peers_ladder.hpp"

// A skeleton of one body on a free joint. Its world has one integrator, semi-implicit Euler. A
// force holds for one step.

namespace rigid_body_sim::peers {
namespace {

Eigen::Vector3d vector(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

class DartWorld {
 public:
  DartWorld(const Problem& problem, double h)
      : problem_(problem), world_(dart::simulation::World::create()) {
    const dart::dynamics::SkeletonPtr skeleton = dart::dynamics::Skeleton::create();
    const auto made = skeleton->createJointAndBodyNodePair<dart::dynamics::FreeJoint>();
    body_ = made.second;
    const auto& I = problem.I;
    body_->setInertia({problem.mass, Eigen::Vector3d::Zero(), vector(I).asDiagonal()});
    made.first->setAngularVelocity(vector(problem.w));
    world_->setGravity(vector(problem.g_W));
    world_->setTimeStep(h);
    world_->addSkeleton(skeleton);
  }

  void step() {
    if (problem_.isPushed())
      body_->addExtForce(vector(problem_.force_W), vector(problem_.arm_P), false, true);
    world_->step();
  }

  Quaternion4 attitude() const {
    const Eigen::Quaterniond q(body_->getWorldTransform().linear());
    return {q.x(), q.y(), q.z(), q.w()};
  }

 private:
  const Problem& problem_;
  dart::simulation::WorldPtr world_;
  dart::dynamics::BodyNode* body_;
};

std::vector<Run> dartRuns(const Problem& problem) {
  constexpr double kLongest = 5e-3;  // [s]
  return steppedRuns(
      "semi-implicit Euler", problem,
      [&](double h) { return std::make_unique<DartWorld>(problem, h); }, kLongest);
}

const Registration kDart({"DART", dartRuns});

}  // namespace
}  // namespace rigid_body_sim::peers
