#include <cmath>
#include <iostream>
#include <memory>
#include <string>

#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/collision/fcl/FCLCollisionDetector.hpp>
#include <dart/constraint/ConstraintSolver.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/EllipsoidShape.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/PlaneShape.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/SphereShape.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/simulation/World.hpp>

#include "benchmark/touch_peers.hpp"
#include "tools/trade/cpu_time.hpp"

// Its own collision detector; the ground is a large box, as it knows no planes there. Friction and
// restitution of a pair: the smaller, the product. An ellipsoid: by FCL, on a plane.

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

/// Primitive shapes and their points of contact as FCL knows them: DART warns that they may be
/// wrong, by which it would fill the screen; a rattleback ends by them where it does by other
/// engines.
std::shared_ptr<dart::collision::CollisionDetector> detectorOfEllipsoids() {
  using Detector = dart::collision::FCLCollisionDetector;
  std::streambuf* screen = std::cerr.rdbuf(nullptr);
  const auto detector = Detector::create();
  detector->setPrimitiveShapeType(Detector::PRIMITIVE);
  detector->setContactPointComputationMethod(Detector::FCL);
  std::cerr.rdbuf(screen);
  return detector;
}

void addGround(const dart::simulation::WorldPtr& world, const TouchCase& c) {
  using dart::dynamics::WeldJoint;
  constexpr double kFriction = 10;
  const auto solver = world->getConstraintSolver();
  if (c.isEllipsoid()) {
    solver->setCollisionDetector(detectorOfEllipsoids());
    const auto plane = std::make_shared<dart::dynamics::PlaneShape>(Eigen::Vector3d::UnitZ(), 0.0);
    addBody<WeldJoint>(world, plane, kFriction, 1);
    return;
  }
  solver->setCollisionDetector(dart::collision::DARTCollisionDetector::create());
  constexpr double kWide = 100, kThick = 1;
  const auto box = std::make_shared<BoxShape>(Eigen::Vector3d(kWide, kWide, kThick));
  const auto ground = addBody<WeldJoint>(world, box, kFriction, 1);
  ground->getParentJoint()->setTransformFromParentBodyNode(
      Eigen::Isometry3d(Eigen::Translation3d(0, 0, -kThick / 2)));
}

TouchRun dartRun(const TouchCase& c, double h) {
  const dart::simulation::WorldPtr world = dart::simulation::World::create();
  world->setGravity(Eigen::Vector3d(0, 0, -kGravity));
  world->setTimeStep(h);
  addGround(world, c);
  ShapePtr shape;
  if (c.isEllipsoid())
    shape = std::make_shared<dart::dynamics::EllipsoidShape>(2 * vector(c.semi_axes));
  else if (c.radius > 0)
    shape = std::make_shared<dart::dynamics::SphereShape>(c.radius);
  else
    shape = std::make_shared<BoxShape>(vector(c.box));
  dart::dynamics::BodyNode* body =
      addBody<dart::dynamics::FreeJoint>(world, shape, c.friction, c.restitution);
  Eigen::Matrix3d inertia = shape->computeInertia(1);
  if (c.isEllipsoid()) {
    inertia = vector(c.inertia).asDiagonal();
    Eigen::Isometry3d place(Eigen::Translation3d(0, 0, c.shape_up));
    place.rotate(Eigen::AngleAxisd(c.shape_turn, Eigen::Vector3d::UnitZ()));
    body->getShapeNode(0)->setRelativeTransform(place);
  }
  body->setInertia({1, Eigen::Vector3d::Zero(), inertia});
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
  const Eigen::Quaterniond q(body->getWorldTransform().linear());
  run.q = {q.x(), q.y(), q.z(), q.w()};
  return run;
}

const TouchRegistration kDartTouch({"DART", kSteps, dartRun, kFineSteps});

}  // namespace
}  // namespace rigid_body_sim::touch_peers
