#include "dynamics/packs/block_lane.hpp"

#include <algorithm>
#include <cmath>

namespace rigid_body_sim {
namespace {

/// Share of what an integrator follows that a body may turn in a step. L is constant to rounding;
/// rk4 lets |L| grow by less than 1e-4 in a step that turns so far.
constexpr double kMaxShare = 0.98;

/// Numbers up to this, and sums of kCertainSteps of their products, are finite.
constexpr double kModest = 1e60;

template <class V, class Block>
void put(int column, const V& values, Block& block, std::size_t lane) {
  for (int i = 0; i < values.size(); ++i) block.columns[column + i][lane] = values(i);
}

double squaredLength(int column, const PackBlock& block, std::size_t lane) {
  const double x = block.columns[column][lane], y = block.columns[column + 1][lane],
               z = block.columns[column + 2][lane];
  return x * x + y * y + z * z;
}

/// Whether |L| leaves the turn of a step within what is followed.
bool turnsSlowly(const PackBlock& block, std::size_t lane) {
  const double turn = block.columns[kTurnColumn][lane], growth = block.columns[kGrowthColumn][lane];
  const double square = std::max(squaredLength(kSpinColumn, block, lane),
                                 squaredLength(kWorldSpinColumn, block, lane));
  if (growth == 0) return turn * turn * square <= kMaxShare * kMaxShare;
  return turn * (std::sqrt(square) + growth) <= kMaxShare;
}

/// [N m] The greatest torque that is held.
double torqueBound(const HeldWrench& held) {
  double bound = held.tau_W.norm() + held.tau_P.norm();
  for (const HeldWrench::BodyPointForce& at : held.body_point_forces)
    bound += at.arm_P.norm() * at.force_W.norm();
  return bound;
}

bool isModest(const PackBlock& block, std::size_t lane) {
  double sum = 0;
  for (int c = 0; c < kForceColumn; ++c) sum += std::abs(block.columns[c][lane]);
  return sum < kModest;
}

// a step looks ahead by its length
constexpr double kSteps = Packs::kCertainSteps + 1;

/// Whether anything acts beside a force at the centre of mass.
bool isLoaded(const SteadyMotion& motion) {
  return motion.drag || (motion.held && !motion.held->torqueFree());
}

/// Drag, and what Stepper asks of it.
void putDrag(const SteadyMotion& motion, double h, PushBlock& block, std::size_t lane) {
  const Body& body = *motion.body;
  const Drag::Coefficients& drag = motion.drag->coefficients();
  block.columns[kLinearDragColumn][lane] = drag.linear;
  block.columns[kQuadraticDragColumn][lane] = drag.quadratic;
  block.columns[kAngularDragColumn][lane] = drag.angular;
  put(kSpinDecayColumn, Vector3d(drag.angular * body.inv_I), block, lane);
  const double share = h / motion.max_turn;
  block.columns[kSlowingColumn][lane] =
      share * std::max(drag.linear / body.mass, drag.angular * body.inv_I.maxCoeff());
  block.columns[kSlowingGainColumn][lane] = share * 2 * drag.quadratic / (body.mass * body.mass);
  const double held = motion.held ? motion.held->f_W.norm() + motion.held->f_P.norm() : 0;
  block.columns[kImpulseColumn][lane] = kSteps * h * (motion.weight_W.norm() + held);
}

}  // namespace

bool staysModest(const PackBlock& block, std::size_t lane) {
  double sum = 0;
  for (int c = kForceColumn; c < kPackColumns; ++c) sum += std::abs(block.columns[c][lane]);
  return sum < kModest;
}

bool staysModest(const PushBlock& block, std::size_t lane) {
  double sum = 0;
  for (const auto& column : block.columns) sum += std::abs(column[lane]);
  return sum < kModest;
}

PackBlock emptyBlock() {
  PackBlock block{};
  for (std::size_t lane = 0; lane < PackBlock::kLanes; ++lane) {
    block.columns[kAttitudeColumn + 3][lane] = 1;
    block.columns[kMassColumn][lane] = 1;
  }
  return block;
}

void putBody(const SteadyMotion& motion, PackKind kind, double h, const BodyState& state,
             PackBlock& block, std::size_t lane) {
  const Body& body = *motion.body;
  put(kPositionColumn, state.x_W, block, lane);
  put(kPositionLowColumn, state.x_low_W, block, lane);
  put(kAttitudeColumn, state.q_WP.coeffs(), block, lane);
  put(kMomentumColumn, state.p_W, block, lane);
  put(kSpinColumn, state.L_P, block, lane);
  put(kWorldSpinColumn, state.L_W, block, lane);
  block.columns[kMagnificationColumn][lane] = motion.magnification;
  const HeldWrench nothing, &held = motion.held ? *motion.held : nothing;
  put(kForceColumn, isLoaded(motion) ? held.f_W : Vector3d(held.at(state).f_W + motion.weight_W),
      block, lane);
  block.columns[kMassColumn][lane] = body.mass;
  const bool is_split =
      kind == PackKind::kStrang02 || kind == PackKind::kStrang20 || kind == PackKind::kStrang12;
  put(kRotationColumn,
      is_split ? Vector3d(body.split.k_a, body.split.k_b, body.split.inv_I_r) : body.inv_I, block,
      lane);
  put(kDifferencesColumn,
      Vector3d(body.I[1] - body.I[2], body.I[2] - body.I[0], body.I[0] - body.I[1]), block, lane);
  block.columns[kTurnColumn][lane] = h * body.inv_I.maxCoeff() / motion.max_turn;
  block.columns[kGrowthColumn][lane] = kSteps * h * torqueBound(held);
}

PackLoad putPush(const SteadyMotion& motion, double h, PushBlock& block, std::size_t lane) {
  const HeldWrench nothing, &held = motion.held ? *motion.held : nothing;
  if (!isLoaded(motion)) return PackLoad::kNone;
  put(kWeightColumn, motion.weight_W, block, lane);
  put(kBodyForceColumn, held.f_P, block, lane);
  put(kCoupleColumn, held.tau_W, block, lane);
  put(kBodyCoupleColumn, held.tau_P, block, lane);
  const auto& at = held.body_point_forces;
  put(kArmColumn, at.empty() ? Vector3d(Vector3d::Zero()) : at.front().arm_P, block, lane);
  put(kArmForceColumn, at.empty() ? Vector3d(Vector3d::Zero()) : at.front().force_W, block, lane);
  if (!motion.drag) return PackLoad::kPush;
  putDrag(motion, h, block, lane);
  return PackLoad::kDrag;
}

bool slowsSlowly(const PackBlock& block, const PushBlock& push, std::size_t lane) {
  const double p = std::sqrt(squaredLength(kMomentumColumn, block, lane));
  return push.columns[kSlowingColumn][lane] +
             push.columns[kSlowingGainColumn][lane] * (p + push.columns[kImpulseColumn][lane]) <=
         kMaxShare;
}

bool isCertain(const PackBlock& block, std::size_t lane) {
  return turnsSlowly(block, lane) && isModest(block, lane);
}

bool areCertain(const PackBlock& block, std::size_t bodies) {
  bool all = true;
  for (std::size_t lane = 0; lane < bodies; ++lane) all &= isCertain(block, lane);
  return all;
}

}  // namespace rigid_body_sim
