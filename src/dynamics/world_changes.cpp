#include "dynamics/world_changes.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <rigid_body_sim/math/rotation.hpp>

#include "dynamics/laws/resting_law.hpp"

namespace rigid_body_sim {

Body changedBody(const Body& body, const MassProperties& properties_B) {
  if (body.fixed)
    throw std::invalid_argument("body '" + body.name + "' is fixed, its mass is ignored");
  std::optional<Vector3d> pivot_B;
  if (body.pivoted) pivot_B = body.X_BP.translation();
  return makeBody(body.name, properties_B, body.actuators, pivot_B);
}

bool isMember(const ForceLaw& law, std::size_t body) {
  const std::vector<std::size_t> members = law.members();
  return std::find(members.begin(), members.end(), body) != members.end();
}

bool rests(const ForceLaw& law, const World& world) {
  const std::vector<std::size_t> members = law.members();
  return std::any_of(members.begin(), members.end(),
                     [&](std::size_t body) { return world.bodies[body].absent; });
}

namespace {

void changeBody(World& world, std::size_t i, const MassProperties& properties_B) {
  const Body before = world.bodies[i];
  const Body& after = world.bodies[i] = changedBody(before, properties_B);
  for (std::shared_ptr<const ForceLaw>& law : world.laws) {
    if (!isMember(*law, i)) continue;
    auto reframed = law->reframed(i, before, after);
    if (!reframed)
      throw std::invalid_argument("body '" + before.name + "': the law '" + law->name() +
                                  "' on it does not follow a change of mass properties");
    law = std::move(reframed);
  }
  for (PointWrench& wrench : world.wrenches) reframe(wrench, i, before, after);
}

void setAbsent(Body& body, bool absent) {
  if (body.fixed)
    throw std::invalid_argument("body '" + body.name + "' is fixed: it is always present");
  body.absent = absent;
}

void restLawsOfAbsent(World& world) {
  for (std::shared_ptr<const ForceLaw>& law : world.laws)
    if (rests(*law, world)) law = std::make_shared<RestingLaw>(std::move(law));
}

bool isSame(const MassProperties& a, const MassProperties& b) {
  return a.mass == b.mass && a.com_B == b.com_B && a.I_Bcm == b.I_Bcm;
}

}  // namespace

bool operator==(const BodyChange& a, const BodyChange& b) {
  if (a.absent != b.absent || a.properties_B.has_value() != b.properties_B.has_value())
    return false;
  return !a.properties_B || isSame(*a.properties_B, *b.properties_B);
}

World withoutChanges(World world) {
  if (!world.unchanged) return world;
  WorldBodies original = *world.unchanged;
  world.bodies = std::move(original.bodies);
  world.wrenches = std::move(original.wrenches);
  world.laws = std::move(original.laws);
  world.unchanged.reset();
  return world;
}

World withChanges(World world, const std::vector<BodyChange>& changes) {
  if (!changes.empty() && changes.size() != world.bodies.size())
    throw std::invalid_argument("a state must have changes for each body, or for none");
  world = withoutChanges(std::move(world));
  const auto any = [](const BodyChange& change) { return change.any(); };
  const auto is_absent = [](const Body& body) { return body.absent; };
  if (std::none_of(changes.begin(), changes.end(), any) &&
      std::none_of(world.bodies.begin(), world.bodies.end(), is_absent))
    return world;
  world.unchanged =
      std::make_shared<const WorldBodies>(WorldBodies{world.bodies, world.wrenches, world.laws});
  for (std::size_t i = 0; i < changes.size(); ++i)
    if (changes[i].properties_B) changeBody(world, i, *changes[i].properties_B);
  for (std::size_t i = 0; i < changes.size(); ++i)
    if (changes[i].absent) setAbsent(world.bodies[i], *changes[i].absent);
  restLawsOfAbsent(world);
  return world;
}

void reframe(PointWrench& wrench, std::size_t body, const Body& before, const Body& after) {
  const Isometry3d X_NP = frameBefore(before, after);
  const auto isFixedToIt = [&](std::size_t frame) {
    return frame == body || (frame == kOwnBody && wrench.body == body);
  };
  if (isFixedToIt(wrench.axes)) {
    wrench.force = X_NP.linear() * wrench.force;
    wrench.torque = X_NP.linear() * wrench.torque;
  }
  if (wrench.at_center && wrench.body == body)
    wrench.point = after.com_P;
  else if (isFixedToIt(wrench.point_frame))
    wrench.point = X_NP * wrench.point;
}

BodyState keepingMomentum(const Body& before, const Body& after, const BodyState& state) {
  const Isometry3d X_NP = frameBefore(before, after);
  if (X_NP.matrix() == Isometry3d::Identity().matrix()) return state;
  BodyState now = state;
  const Matrix3d R_NP = X_NP.linear();
  now.q_WP = product(state.q_WP, Quaterniond(R_NP.transpose())).normalized();
  now.L_P = R_NP * state.L_P;
  // of q and −q, the attitude of the body frame that was
  if (toBodyFrameMotion(before, state).q_WB.dot(toBodyFrameMotion(after, now).q_WB) < 0)
    now.q_WP.coeffs() *= -1;
  if (before.pivoted || before.X_BP.translation() == after.X_BP.translation()) return now;
  // from the origin of P to that of N
  const Vector3d d_W = rotate(state.q_WP, Vector3d(X_NP.inverse().translation()));
  const Vector3d low_W = state.x_low_W + d_W;
  now.x_W = state.x_W + low_W;
  now.x_low_W = low_W - (now.x_W - state.x_W);
  const Vector3d gained_W = -d_W.cross(state.p_W);
  now.L_W = state.L_W + gained_W;
  now.L_P += rotateBack(now.q_WP, gained_W);
  return now;
}

}  // namespace rigid_body_sim
