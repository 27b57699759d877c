#include <memory>
#include <string>

#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/simulation/World.hpp>

#include "benchmark/peers_ladder.hpp"

// A skeleton of one body on a free joint. Its world has one integrator, semi-implicit Euler. A
// force holds for one step.

namespace rigid_body_sim::peers {
namespace {

Eigen::Vector3d vector(const Array3& v) { return {v[0], v[1], v[2]}; }

Array3 array(const Eigen::Vector3d& v) { return {v[0], v[1], v[2]}; }

class DartWorld {
 public:
  DartWorld(const Problem& problem, double h)
      : problem_(problem), world_(dart::simulation::World::create()) {
    const dart::dynamics::SkeletonPtr skeleton = dart::dynamics::Skeleton::create();
    const auto made = skeleton->createJointAndBodyNodePair<dart::dynamics::FreeJoint>();
    body_ = made.second;
    const Problem hub = hubOf(problem);
    body_->setInertia({hub.mass, Eigen::Vector3d::Zero(), vector(hub.I).asDiagonal()});
    if (problem.wheels) addWheels(*problem.wheels);
    const Motion& start = problem.start;
    Eigen::Isometry3d pose(Eigen::Quaterniond(start.q.data()));  // x y z w
    pose.translation() = vector(start.x_W);
    made.first->setTransform(pose);
    made.first->setLinearVelocity(vector(start.v_W));
    made.first->setAngularVelocity(vector(inWorldAxes(start.q, start.w_P)));
    world_->setGravity(vector(problem.g_W));
    world_->setTimeStep(h);
    world_->addSkeleton(skeleton);
  }

  void step() {
    pullForStep(problem_, *this, [&](const Pull& pull) { apply(pull); });
    if (drive_) turnWheels(drive_->next(world_->getTimeStep()));
    world_->step();
  }

  Motion motion() const {
    const Eigen::Quaterniond q(body_->getWorldTransform().linear());
    const Quaternion4 attitude{q.x(), q.y(), q.z(), q.w()};
    return {array(body_->getCOM()), array(body_->getCOMLinearVelocity()), attitude,
            inBodyAxes(attitude, array(body_->getAngularVelocity()))};
  }

 private:
  void apply(const Pull& pull) {
    body_->addExtForce(vector(pull.force_W), vector(pull.arm_P), false, true);
    body_->addExtTorque(vector(pull.torque_W), false);
  }

  void addWheels(const ReactionWheels& wheels) {
    for (std::size_t k = 0; k < 3; ++k) {
      using dart::dynamics::RevoluteJoint;
      RevoluteJoint::Properties hinge;
      hinge.mName = "hinge " + std::to_string(k);  // or it prints that it gives it a name
      hinge.mAxis = Eigen::Vector3d::Unit(static_cast<Eigen::Index>(k));
      dart::dynamics::BodyNode::Properties disc;
      disc.mName = "wheel " + std::to_string(k);
      const auto made = body_->createChildJointAndBodyNodePair<RevoluteJoint>(hinge, disc);
      made.second->setInertia(
          {wheels.mass, Eigen::Vector3d::Zero(), vector(wheelMoments(wheels, k)).asDiagonal()});
      wheel_joints_[k] = made.first;
    }
    drive_.emplace(wheels);
  }

  void turnWheels(const Array3& torque_P) {
    for (std::size_t k = 0; k < 3; ++k) wheel_joints_[k]->setForce(0, torque_P[k]);
  }

  const Problem& problem_;
  dart::simulation::WorldPtr world_;
  dart::dynamics::BodyNode* body_;
  std::array<dart::dynamics::RevoluteJoint*, 3> wheel_joints_{};
  std::optional<WheelDrive> drive_;
};

std::vector<Run> dartRuns(const Problem& problem) {
  constexpr double kLongest = 5e-3;  // [s]
  return steppedRuns(
      "semi-implicit Euler", problem,
      [&](double h) { return std::make_unique<DartWorld>(problem, h); }, kLongest);
}

Motion dartEnd(const Problem& problem, double h, int steps) {
  return endOf(DartWorld(problem, h), steps);
}

const Registration kDart({"DART", dartRuns, {{"DART", dartEnd}}});

}  // namespace
}  // namespace rigid_body_sim::peers
