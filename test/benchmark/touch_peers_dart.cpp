#include <cmath>
#include <memory>
#include <string>

#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/constraint/ConstraintSolver.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/SphereShape.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>

#include "benchmark/touch_peers.hpp"
#include "tools/trade/cpu_time.hpp"

// Its own collision detector; the ground is a large box, as it knows no planes there. Friction and
// restitution of a pair: the smaller, the product.

namespace rigid_body_sim::touch_peers {
namespace {

using dart::dynamics::BoxShape;
using dart::dynamics::CollisionAspect;
using dart::dynamics::DynamicsAspect;
using dart::dynamics::ShapePtr;
using dart::dynamics::Skeleton;

Eigen::Vector3d vector(const Array3& v) { return {v[0], v[1], v[2]}; }

template <class Joint>
dart::dynamics::BodyNode* addBody(const dart::simulation::WorldPtr& world, const ShapePtr& shape,
                                  double friction, double restitution) {
  // names of their own, or it prints that it gives them some
  const dart::dynamics::SkeletonPtr skeleton =
      Skeleton::create("skeleton" + std::to_string(world->getNumSkeletons()));
  dart::dynamics::BodyNode* body = skeleton->createJointAndBodyNodePair<Joint>().second;
  auto* node = body->createShapeNodeWith<CollisionAspect, DynamicsAspect>(shape);
  node->getDynamicsAspect()->setFrictionCoeff(friction);
  node->getDynamicsAspect()->setRestitutionCoeff(restitution);
  world->addSkeleton(skeleton);
  return body;
}

TouchRun dartRun(const TouchCase& c, double h) {
  const dart::simulation::WorldPtr world = dart::simulation::World::create();
  world->setGravity(Eigen::Vector3d(0, 0, -kGravity));
  world->setTimeStep(h);
  world->getConstraintSolver()->setCollisionDetector(
      dart::collision::DARTCollisionDetector::create());
  constexpr double kWide = 100, kThick = 1;
  const auto ground = addBody<dart::dynamics::WeldJoint>(
      world, std::make_shared<BoxShape>(Eigen::Vector3d(kWide, kWide, kThick)), 10, 1);
  ground->getParentJoint()->setTransformFromParentBodyNode(
      Eigen::Isometry3d(Eigen::Translation3d(0, 0, -kThick / 2)));
  ShapePtr shape;
  if (c.radius > 0)
    shape = std::make_shared<dart::dynamics::SphereShape>(c.radius);
  else
    shape = std::make_shared<BoxShape>(vector(c.box));
  dart::dynamics::BodyNode* body =
      addBody<dart::dynamics::FreeJoint>(world, shape, c.friction, c.restitution);
  body->setInertia({1, Eigen::Vector3d::Zero(), shape->computeInertia(1)});
  auto* joint = static_cast<dart::dynamics::FreeJoint*>(body->getParentJoint());
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  const Eigen::Vector3d turn = vector(c.rotation);
  if (turn.norm() > 0) pose.linear() = Eigen::AngleAxisd(turn.norm(), turn.normalized()).matrix();
  pose.translation() = vector(c.x_W);
  joint->setTransform(pose);
  joint->setLinearVelocity(vector(c.v_W));
  joint->setAngularVelocity(vector(c.w_W));
  const auto steps = static_cast<int>(std::lround(c.duration / h));
  const double begin = cpuTime();
  for (int k = 0; k < steps; ++k) world->step();
  TouchRun run{"h " + std::to_string(h), cpuTime() - begin, {}};
  const Eigen::Vector3d x = body->getCOM();
  run.x_W = {x[0], x[1], x[2]};
  return run;
}

const TouchRegistration kDartTouch({"DART", kSteps, dartRun});

}  // namespace
}  // namespace rigid_body_sim::touch_peers
