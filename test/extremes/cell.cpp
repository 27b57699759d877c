#include "cell.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "dynamics/rotation/free_top.hpp"
#include "support/reference_free_rotation.hpp"

namespace rigid_body_sim::extremes {
namespace {

using reference::Motion;
using reference::Real;
using reference::Vector;

Real energyOf(const Body& body, const Motion& m) {
  return Real(body.mass) * m.v.squaredNorm() / 2 +
         body.I.cast<Real>().dot(m.w.cwiseAbs2().eval()) / 2;
}

Real relative(Real error, Real size) { return size > 0 ? error / size : error; }

/// L_P with the magnitude of L_W: to a unit of rounding a state's two accounts of the angular
/// momentum are two motions, and the free top's is this one.
Vector angularMomentumOf(const BodyState& s) {
  const Vector L_P = s.L_P.cast<Real>();
  const Real size = L_P.norm();
  return size > 0 ? Vector(L_P / size * s.L_W.cast<Real>().norm()) : L_P;
}

template <class R>
void turnBySeries(const Body& body, const BodyState& start, double duration, Motion& m) {
  ReferenceFreeRotation<R> reference(body.I, start.q_WP, angularMomentumOf(start));
  reference.advance(R(duration));
  const ReferenceRotation<R>& end = reference.state();
  m.q = Quaternion<Real>(Real(end.q[0]), Real(end.q[1]), Real(end.q[2]), Real(end.q[3]));
  m.w = Vector(Real(end.w[0]), Real(end.w[1]), Real(end.w[2]));
}

void turnFreely(const Body& body, const BodyState& start, double duration, Truth truth, Motion& m) {
  if (truth == Truth::series) return turnBySeries<Real>(body, start, duration, m);
  if (truth == Truth::quad_series) return turnBySeries<Quad>(body, start, duration, m);
  const Vector I = body.I.cast<Real>();
  const RotationState<Real> end =
      FreeTop<Real>(I)
          .from(start.q_WP.cast<Real>(), angularMomentumOf(start), start.L_W.cast<Real>())
          .at(Real(duration));
  m.q = end.q_WP;
  m.w = end.L_P.cwiseQuotient(I);
}

}  // namespace

bool Cell::finite() const {
  return std::isfinite(attitude) && std::isfinite(position) && std::isfinite(energy) &&
         std::isfinite(angular_momentum);
}

Ends freeEnds(const test::Bench& bench, double duration, Truth truth) {
  const Real t(duration);
  const Vector g = bench.world.g_W.cast<Real>();
  Ends ends;
  for (std::size_t i = 0; i < bench.world.bodies.size(); ++i) {
    Motion m = reference::toMotion(bench.world.bodies[i], bench.initial.bodies[i]);
    turnFreely(bench.world.bodies[i], bench.initial.bodies[i], duration, truth, m);
    m.x = (m.v + g * (t / 2)) * t;
    m.v += g * t;
    ends.motions.push_back(m);
  }
  return ends;
}

Ends referenceEnds(const test::Bench& bench, double duration) {
  Ends ends{test::referenceRun(bench, duration)};
  for (std::size_t i = 0; i < ends.motions.size(); ++i)
    ends.motions[i].x -= reference::toMotion(bench.world.bodies[i], bench.initial.bodies[i]).x;
  return ends;
}

void compare(const test::Bench& bench, const State& state, const Ends& truth, Cell& cell) {
  if (truth.motions.size() != state.bodies.size())
    throw std::logic_error("no truth to compare with");
  Real attitude = 0, position = 0, energy = 0, angular_momentum = 0;
  // where one is not a number, so is the sum
  for (std::size_t i = 0; i < truth.motions.size(); ++i) {
    const Body& body = bench.world.bodies[i];
    const Motion now = reference::toMotion(body, state.bodies[i]);
    const BodyState& s = state.bodies[i];
    const BodyState& start = bench.initial.bodies[i];
    const Vector way =
        Vector3d(s.x_W - start.x_W).cast<Real>() + Vector3d(s.x_low_W - start.x_low_W).cast<Real>();
    const Motion& m = truth.motions[i];
    const Vector L = m.R() * m.w.cwiseProduct(body.I.cast<Real>());
    const Real E = energyOf(body, m);
    const auto keepWorst = [](Real& worst, Real error) {
      if (!(error <= worst)) worst = error;
    };
    keepWorst(attitude, reference::attitudeError(s.q_WP, m));
    keepWorst(position, relative((way - m.x).norm(), m.x.norm()));
    keepWorst(energy, relative(std::abs(energyOf(body, now) - E), E));
    keepWorst(angular_momentum, relative((s.L_W.cast<Real>() - L).norm(), L.norm()));
  }
  cell.attitude = double(attitude);
  cell.position = double(position);
  cell.energy = double(energy);
  cell.angular_momentum = double(angular_momentum);
}

std::map<std::string, Measure>& others() {
  static std::map<std::string, Measure> all;
  return all;
}

Cell measure(Cell cell, const test::Bench& bench, const Run& run, const Ends& truth) {
  const auto other = others().find(cell.integrator);
  if (other != others().end()) return other->second(cell, bench, run, truth);
  try {
    Simulation simulation = bench.simulation(cell.integrator, run.time_step);
    for (const MotionPlan& plan : simulation.plans())
      if (!plan.holds) cell.warned = "no integrator was found to hold the scene's tolerance";
    for (int i = 0; i < run.steps; ++i) simulation.step();
    compare(bench, simulation.state(), truth, cell);
  } catch (const SimulationDiverged& stopped) {
    cell.said = stopped.what();
  }
  return cell;
}

void measureAll(const Cell& cell, const Names& integrators, const test::Bench& bench,
                const Run& run, const Ends& truth, Cells& cells) {
  for (const std::string& integrator : integrators) {
    Cell of_one = cell;
    of_one.integrator = integrator;
    cells.push_back(measure(of_one, bench, run, truth));
  }
}

}  // namespace rigid_body_sim::extremes
