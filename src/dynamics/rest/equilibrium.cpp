#include "dynamics/rest/equilibrium.hpp"

#include <cmath>
#include <limits>

#include <rigid_body_sim/math/rotation.hpp>

#include "dynamics/rotation/free_motion.hpp"

namespace rigid_body_sim {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The velocities of all bodies, and what they multiply to momenta.
VectorXd velocitiesOf(const System& system, const SystemState& states) {
  VectorXd v(6 * static_cast<std::ptrdiff_t>(system.bodies.size()));
  for (std::size_t k = 0; k < system.bodies.size(); ++k) {
    const BodyState& s = states.bodies[k];
    const auto first = 6 * static_cast<std::ptrdiff_t>(k);
    v.segment<3>(first) = s.p_W / system.bodies[k]->mass;
    v.segment<3>(first + 3) = rotate(s.q_WP, angularVelocity(system.bodies[k]->inv_I, s.L_P));
  }
  return v;
}

MatrixXd massesOf(const System& system, const SystemState& states) {
  const auto size = 6 * static_cast<std::ptrdiff_t>(system.bodies.size());
  MatrixXd masses = MatrixXd::Zero(size, size);
  for (std::size_t k = 0; k < system.bodies.size(); ++k) {
    const Body& body = *system.bodies[k];
    const Eigen::Matrix3d R = states.bodies[k].q_WP.toRotationMatrix();
    const auto first = 6 * static_cast<std::ptrdiff_t>(k);
    masses.block<3, 3>(first, first).diagonal().setConstant(body.mass);
    masses.block<3, 3>(first + 3, first + 3) = R * body.I.asDiagonal() * R.transpose();
  }
  return masses;
}

void stop(SystemState& states) {
  for (BodyState& s : states.bodies) {
    s.p_W.setZero();
    s.L_W.setZero();
    s.L_P.setZero();
  }
}

}  // namespace

Equilibrium::Equilibrium(const System& system, const SystemState& states, double longest)
    : system_(system),
      states_(states),
      velocity_(velocitiesOf(system, states)),
      mass_(massesOf(system, states)) {
  stop(states_);
  findStiffness(longest);
  findModes();
}

/// What acts on the bodies: force, and torque about the centre of mass, in axes of the world.
Equilibrium::Vector Equilibrium::forcesAt(const SystemState& states) {
  evaluateAllWrenches(system_, states, workspace_);
  Vector forces(size());
  for (std::size_t k = 0; k < system_.bodies.size(); ++k) {
    const Wrench& wrench = workspace_.wrenches[k];
    const auto first = 6 * static_cast<std::ptrdiff_t>(k);
    forces.segment<3>(first) = wrench.f_W;
    forces.segment<3>(first + 3) = wrench.tau_W + rotate(states.bodies[k].q_WP, wrench.tau_P);
  }
  return forces;
}

/// Where the bodies are after the velocity u for a second; small, so that the states of laws, which
/// follow the velocity, are those after a motion along a straight line.
SystemState Equilibrium::movedBy(const Vector& u) const {
  SystemState moved = states_;
  for (std::size_t k = 0; k < system_.bodies.size(); ++k) {
    const Body& body = *system_.bodies[k];
    BodyState& s = moved.bodies[k];
    const auto first = 6 * static_cast<std::ptrdiff_t>(k);
    s.p_W = body.mass * u.segment<3>(first);
    s.L_P = body.I.cwiseProduct(rotateBack(s.q_WP, Vector3d(u.segment<3>(first + 3))));
  }
  std::vector<double> rates, rates_at_rest;
  evaluateLawRates(system_, moved, rates);
  evaluateLawRates(system_, states_, rates_at_rest);  // of bristles without a load
  for (std::size_t i = 0; i < rates.size(); ++i) moved.laws[i] += rates[i] - rates_at_rest[i];
  for (std::size_t k = 0; k < system_.bodies.size(); ++k) {
    BodyState& s = moved.bodies[k];
    const auto first = 6 * static_cast<std::ptrdiff_t>(k);
    moveBy(Vector3d(u.segment<3>(first)), s);
    s.q_WP = product(rotationExp(Vector3d(u.segment<3>(first + 3))), s.q_WP);
    s.q_WP.normalize();
  }
  stop(moved);
  return moved;
}

void Equilibrium::findStiffness(double longest) {
  stiffness_.resize(size(), size());
  for (std::ptrdiff_t i = 0; i < size(); ++i) {
    const Body& body = *system_.bodies[static_cast<std::size_t>(i / 6)];
    const double step = i % 6 < 3 ? longest : longest / radiusOfGyration(body);
    Vector u = Vector::Zero(size());
    u[i] = step;
    stiffness_.col(i) = (forcesAt(movedBy(-u)) - forcesAt(movedBy(u))) / (2 * step);
  }
}

void Equilibrium::findModes() {
  constexpr double kAsymmetry = 1e-4, kNeutral = 1e-7;
  if (!stiffness_.allFinite()) return;
  // in coordinates in which masses are one, so that lengths and angles compare
  const Vector scale = mass_.diagonal().cwiseSqrt().cwiseInverse();
  const MatrixXd scaled = scale.asDiagonal() * stiffness_ * scale.asDiagonal();
  stiffness_ = 0.5 * (stiffness_ + stiffness_.transpose()).eval();
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> solver(stiffness_, mass_);
  if (solver.info() != Eigen::Success) return;
  modes_ = solver.eigenvectors();
  squares_ = solver.eigenvalues();
  const double fastest = squares_.maxCoeff();
  stable_ = fastest > 0 && squares_.minCoeff() > -kNeutral * fastest &&
            (scaled - scaled.transpose()).cwiseAbs().maxCoeff() < kAsymmetry * fastest;
  squares_ = (squares_.array() > kNeutral * fastest).select(squares_, 0);
}

bool Equilibrium::find() {
  constexpr int kMaxIterations = 20;
  Vector away = Vector::Zero(size());  // along the modes, from here to the equilibrium
  double last = std::numeric_limits<double>::infinity();
  for (int i = 0; i < kMaxIterations; ++i) {
    const Vector forces = forcesAt(states_);
    pushes_ = modes_.transpose() * forces;
    const Vector step = (squares_.array() > 0).select(pushes_.cwiseQuotient(squares_), 0);
    const double size_of_step = step.norm();
    if (!std::isfinite(size_of_step)) return false;
    if (size_of_step == 0 || size_of_step > 0.5 * last) break;
    last = size_of_step;
    states_ = movedBy(modes_ * step);
    away += step;
  }
  constexpr double kSmall = 1e-6, kRounding = 1e-14;
  if (last > kSmall * std::max(away.norm(), 1e-9)) return false;
  noise_ = kRounding * system_.g_W.norm() * std::sqrt(mass_.diagonal().maxCoeff());
  speeds_ = modes_.transpose() * (mass_ * velocity_);
  const Vector of_modes = speeds_.cwiseAbs2() + squares_.cwiseProduct(away.cwiseAbs2());
  energy_ = 0.5 * (squares_.array() > 0).select(of_modes, 0).sum();
  return true;
}

/// Of the three coordinates from `first` on. With C = Σ φ φᵀ/λ, |u|² <= 2 E trace C at the energy
/// E.
double Equilibrium::bound(std::size_t first, double duration) const {
  const auto rows = modes_.middleRows<3>(static_cast<std::ptrdiff_t>(first));
  double compliance = 0, drift = 0;
  for (std::ptrdiff_t i = 0; i < size(); ++i) {
    const double share = rows.col(i).squaredNorm();
    if (squares_[i] > 0) {
      compliance += share / squares_[i];
    } else {
      const double push = std::abs(pushes_[i]) <= noise_ ? 0 : std::abs(pushes_[i]);
      drift += std::sqrt(share) * duration * (std::abs(speeds_[i]) + 0.5 * duration * push);
    }
  }
  return std::sqrt(2 * energy_ * compliance) + drift;
}

}  // namespace rigid_body_sim
