#include <cmath>
#include <utility>

#include <gtest/gtest.h>

#include "support/contact_benches.hpp"

/// A rattleback, which turns back, slips often, and rebounds from its ends.
namespace rigid_body_sim {
namespace {

using test::Bench;
using test::contactOf;

/// The turning of an ellipsoid whose centre of mass lies a height below its centre, and which rolls
/// without slipping: with r the arm of the point of contact and v = −ω × r,
///   (I − m r× r×) ω' = r × m (g n − ω × (ω × r + r')) − ω × I ω
/// in body axes, by the classical Runge-Kutta method.
class PureRolling {
 public:
  PureRolling(const Vector3d& semi_axes, double height, const Matrix3d& I, const Quaterniond& q,
              const Vector3d& w_B)
      : d_(semi_axes), c_(0, 0, height), I_(I) {
    y_ << q.coeffs(), w_B;
  }
  double spin() const { return y_[6]; }

  void advance(double duration) {
    const int steps = static_cast<int>(std::lround(duration / 1e-4));
    const double h = duration / steps;
    for (int i = 0; i < steps; ++i) {
      const Numbers a = rate(y_), b = rate(y_ + h / 2 * a), c = rate(y_ + h / 2 * b),
                    d = rate(y_ + h * c);
      y_ += h / 6 * (a + 2 * b + 2 * c + d);
    }
  }

 private:
  using Numbers = Eigen::Matrix<double, 7, 1>;

  Numbers rate(const Numbers& y) const {  // of 1 kg
    const Quaterniond q = Quaterniond(y[3], y[0], y[1], y[2]).normalized();
    const Vector3d w = y.tail<3>(), n = q.conjugate() * Vector3d(0, 0, 1), n_dot = n.cross(w);
    const Vector3d dn = d_.cwiseProduct(n), dn_dot = d_.cwiseProduct(n_dot);
    const double s = dn.norm();
    const Vector3d r = c_ - d_.cwiseProduct(dn) / s;
    const Vector3d r_dot =
        -d_.cwiseProduct(dn_dot) / s + d_.cwiseProduct(dn) * dn.dot(dn_dot) / (s * s * s);
    Matrix3d cross;
    cross << 0, -r[2], r[1], r[2], 0, -r[0], -r[1], r[0], 0;
    const Matrix3d about_contact = I_ - cross * cross;
    const Vector3d push = 9.81 * n - w.cross(Vector3d(w.cross(r) + r_dot));
    const Vector3d w_dot = about_contact.inverse() * (r.cross(push) - w.cross(Vector3d(I_ * w)));
    const Quaterniond q_dot = q * Quaterniond(0, w[0], w[1], w[2]);
    Numbers y_dot;
    y_dot << q_dot.coeffs() / 2, w_dot;
    return y_dot;
  }

  Vector3d d_, c_;
  Matrix3d I_;
  Numbers y_;
};

/// Kane & Levinson, Int. J. Non-Linear Mech. 17 (1982) 175: spun the way that it does not like, as
/// it rolls.
struct Rattleback {
  static constexpr double kHeight = 0.01;  // [m]
  Vector3d semi_axes{0.2, 0.03, 0.02}, w_B{0, 0, -5};
  Matrix3d I;
  BodyFrameMotion start;
  Bench bench;

  /// depth [m]: of its lowest point in the ground.
  Rattleback(ContactParameters parameters, double breakaway, double depth) {
    parameters.breakaway = breakaway;
    bench.world.g_W = {0, 0, -9.81};
    I << 2e-4, -2e-5, 0, -2e-5, 16e-4, 0, 0, 0, 17e-4;
    const Body body = makeBody("rattleback", {1, {0, 0, -kHeight}, I});
    start.q_WB = Quaterniond(0.99998, 0.0043633, 0.0043633, 0).normalized();
    const Vector3d n_B = rotateBack(start.q_WB, Vector3d(Vector3d::UnitZ()));
    const Vector3d scaled = semi_axes.cwiseProduct(n_B);
    const Vector3d lowest = -semi_axes.cwiseProduct(scaled) / scaled.norm();
    start.x_W.z() = scaled.norm() - depth;
    start.w_W = rotate(start.q_WB, w_B);
    start.v_W = -start.w_W.cross(rotate(start.q_WB, lowest));
    bench.add(body, start);
    const Isometry3d X_PB = body.X_BP.inverse();
    ContactShape shape;
    shape.ellipsoids = {{X_PB.translation(), Quaterniond(X_PB.linear()), semi_axes}};
    bench.world.laws = {
        contactWithHalfSpace(bench.world.bodies, 0, shape, HalfSpace{}, parameters)};
  }
};

// A stiff ground that hardly yields comes near pure rolling.
TEST(Rattleback, TurnsBackAsItDoesInPureRolling) {
  Rattleback rattleback(contactOf(1e8, 1, 0.4, 2), 1e-6, 9.81e-8);
  Simulation sim = rattleback.bench.simulation("auto", 0.01);
  PureRolling rolling(rattleback.semi_axes, Rattleback::kHeight, rattleback.I,
                      rattleback.start.q_WB, rattleback.w_B);
  for (int half = 1; half <= 6; ++half) {
    while (sim.steps() < 50 * half) sim.step();
    rolling.advance(0.5);
    const BodyFrameMotion now = toBodyFrameMotion(sim.world().bodies[0], sim.body(0));
    // measured: 4e-3 rad/s; 5e-4 rad/s at a tenfold stiffness
    EXPECT_NEAR(rotateBack(now.q_WB, now.w_W).z(), rolling.spin(), 0.01) << sim.time();
  }
  EXPECT_GT(rolling.spin(), 0.2);  // it has turned back
}

// It slips a hundred times a second, often for less than a quarter of a step. A slip that is missed
// shows by up to 1e-4 rad after four seconds, whatever the bound.
TEST(Rattleback, ErrsInProportionToTheBoundOfItsSteps) {
  Bench bench = Rattleback(contactOf(1e8, 1.5, 0.4, 1), 1e-4, 0).bench;
  const auto endAt = [&bench](double bound) {
    bench.initial.contact_bound = bound;
    Simulation sim = bench.simulation("auto", 0.002);
    while (sim.steps() < 2000) sim.step();
    return sim.body(0);
  };
  const BodyState truth = endAt(1e-14);
  // measured: 2 to 31 times the bound, the growth of errors on its way
  for (const double bound : {1e-6, 1e-8, 1e-10, 1e-12})
    EXPECT_LT(angleBetween(endAt(bound).q_WP, truth.q_WP), 200 * bound) << bound;
}

// Released at the depth at which it rests, it rocks, hardly letting go, and rebounds from its ends
// from 1.6 s on; what two runs differ by grows hundreds of times then. What a run errs by at 4 s is
// what that makes of its error at 1.6 s: steps to rounding from there on change nothing.
TEST(Rattleback, ErrsByWhatItsReboundsMakeOfEarlyErrors) {
  const double depth = std::pow(9.81 / 1e8, 1 / 1.5);
  Bench bench = Rattleback(contactOf(1e8, 1.5, 0.4, 1), 1e-4, depth).bench;
  const auto go = [&bench](State from, double bound, int steps) {
    from.contact_bound = bound;
    bench.initial = std::move(from);
    Simulation sim = bench.simulation("auto", 0.002);
    while (sim.steps() < steps) sim.step();
    return sim.state();
  };
  const auto apart = [](const State& a, const State& b) {
    return angleBetween(a.bodies[0].q_WP, b.bodies[0].q_WP);
  };
  constexpr double kRounding = 1e-14, kBound = 1e-8;
  constexpr int kMiddle = 800, kEnd = 2000;
  const State start = bench.initial;
  const State true_middle = go(start, kRounding, kMiddle), middle = go(start, kBound, kMiddle);
  EXPECT_LT(apart(middle, true_middle), 50 * kBound);  // measured: 28 times it
  const State truth = go(true_middle, kRounding, kEnd), end = go(middle, kBound, kEnd);
  const double grown = apart(go(middle, kRounding, kEnd), truth);
  EXPECT_GT(grown, 100 * apart(middle, true_middle));  // measured: 600 times
  EXPECT_NEAR(apart(end, truth), grown, 0.1 * grown);  // measured: 0.001
}

}  // namespace
}  // namespace rigid_body_sim
