#pragma once

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "dynamics/taylor/taylor_segment.hpp"
#include "support/applied_load.hpp"
#include "support/random_bodies.hpp"
#include "support/reference_motion.hpp"

/// Bodies, wrenches and errors that the tests of Taylor segments share.
namespace rigid_body_sim {

using reference::Real;

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

inline Body bodyOf(double mass, const Vector3d& I) {
  Body body;
  body.mass = mass;
  body.I = I;
  body.inv_I = I.cwiseInverse();
  body.X_BP.setIdentity();
  body.q_BP.setIdentity();
  return body;
}

inline BodyState turningAt(const Body& body, const Vector3d& w_P) {
  BodyState state;
  state.L_P = body.I.cwiseProduct(w_P);
  state.L_W = rotate(state.q_WP, state.L_P);
  return state;
}

inline HeldWrench held(const std::vector<PointWrench>& applied) {
  HeldWrenchSum sum;
  for (const PointWrench& a : applied) sum.add(a);
  return sum.sum();
}

/// Five kinds of wrench: a couple and a force at a point of the body, both with world axes; the
/// two with the body's; a force at a world point. alpha: the angular acceleration they are made to
/// cause, about [rad/s²].
inline PointWrench randomWrench(Draw& draw, int kind, const Body& body, double alpha) {
  const double torque = alpha * body.I.maxCoeff();
  const double length = std::sqrt(body.I.maxCoeff() / body.mass);
  PointWrench a;
  if (kind == 0) a.torque = draw.vector(torque);
  if (kind == 1 || kind == 4) a.force = draw.vector(torque / length);
  if (kind == 1 || kind == 4) a.point = draw.vector(length);
  if (kind == 2 || kind == 3) a.axes = 0;
  if (kind == 2) a.torque = body.I.cwiseProduct(draw.vector(alpha));
  if (kind == 3) a.force = draw.vector(torque / length);
  if (kind == 4) a.point_frame = kWorld;
  return a;
}

/// Greatest errors of a state against the reference: attitude [rad]; the rest relative.
struct Errors {
  Real attitude = 0;
  Real w = 0;
  Real L_P = 0;
  Real L_W = 0;
  Real x = 0;
  Real p = 0;

  void add(const Body& body, const BodyState& s, const reference::Motion& m, Real w_size) {
    const reference::Vector I = body.I.cast<Real>();
    const reference::Vector L = I.cwiseProduct(m.w);
    const Real w_scale = std::max(m.w.norm(), w_size);
    const Real L_scale = std::max(L.norm(), w_size * I.minCoeff());
    const reference::Vector position = s.x_W.cast<Real>() + s.x_low_W.cast<Real>();
    attitude = std::max(attitude, reference::attitudeError(s.q_WP, m));
    w = std::max(w, (s.L_P.cast<Real>().cwiseQuotient(I) - m.w).norm() / w_scale);
    L_P = std::max(L_P, (s.L_P.cast<Real>() - L).norm() / L_scale);
    L_W = std::max(L_W, (s.L_W.cast<Real>() - m.R() * L).norm() / L_scale);
    x = std::max(x, (position - m.x).norm() / (1 + m.x.norm()));
    p = std::max(p, (s.p_W.cast<Real>() / Real(body.mass) - m.v).norm() / (1 + m.v.norm()));
  }
};

const Vector3d kGravity(0, 0, -9.81);

}  // namespace rigid_body_sim
