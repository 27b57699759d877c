#include "dynamics/contact/normal_law.hpp"

#include <algorithm>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace rigid_body_sim {
namespace {

void requireConstant(bool holds, const char* rule, double got) {
  if (holds) return;
  std::ostringstream text;
  text.precision(17);
  text << "contact: " << rule << ", got " << got;
  throw std::invalid_argument(text.str());
}

/// x = d v and e as functions of y = −ln((1 − e x)/(1 + x)) > 0:
///   x = y/(1 − E) − 1,   e = (1 − (1 + y) E)/(y − 1 + E),   E = exp(−y)
/// Both e and 1 − e, each without cancellation:
///   y < 1:  e = Σ yⁿ/n! / Σ (n − 1) yⁿ/n!,   1 − e = Σ (n − 2) yⁿ/n! / Σ (n − 1) yⁿ/n!,   n >= 2
struct Restitution {
  double e, loss;

  explicit Restitution(double y) {
    if (y >= 1) {
      const double E = std::exp(-y);
      e = (1 - (1 + y) * E) / (y - 1 + E);
      loss = 1 - e;
      return;
    }
    double term = y, kept = 0, lost = 0;
    for (int n = 2; n < 30; ++n) {
      term *= y / n;
      kept += term;
      lost += (n - 2) * term;
    }
    e = kept / (kept + lost);
    loss = lost / (kept + lost);
  }
};

/// y/(1 − exp(−y)) − 1 for y > 0, without cancellation.
double speedRatioAt(double y) {
  if (y > 1) return y / -std::expm1(-y) - 1;
  // (y − 1 + E)/(1 − E), the numerator by its series
  double term = 1, sum = 0;
  for (int n = 1; n < 30; ++n) {
    term *= -y / n;
    if (n > 1) sum += term;
  }
  return sum / -std::expm1(-y);
}

}  // namespace

double dissipationForRestitution(double e, double approach_speed) {
  requireConstant(e > 0 && e <= 1,
                  "restitution must be > 0 and <= 1 (0 would need infinite dissipation)", e);
  requireConstant(approach_speed > 0 && std::isfinite(approach_speed),
                  "the speed at which restitution is given must be > 0 m/s", approach_speed);
  if (e == 1) return 0;
  // e falls with y, from 1 at 0 to 1/y
  const auto off = [e](double y) {
    const Restitution at(y);
    return e > 0.5 ? (1 - e) - at.loss : at.e - e;
  };
  double low = 0, high = 2 / e + 2, y = (1 - e) * (2 + 1 / e);
  for (int i = 0; i < 200; ++i) {
    if (!(y > low && y < high)) y = 0.5 * (low + high);
    const double rest = off(y), step = 1e-6 * y;
    (rest > 0 ? low : high) = y;
    const double next = y - rest * 2 * step / (off(y + step) - off(y - step));
    if (next == y || !(high - low > 1e-16 * high)) break;
    y = next;
  }
  const double dissipation = speedRatioAt(y) / approach_speed;
  requireConstant(std::isfinite(dissipation),
                  "the speed at which restitution is given is too small", approach_speed);
  return dissipation;
}

// The force rises as t^p from a touch on, and falls so towards a release. Where p is not 1, no
// estimate of a step that begins or ends there can be believed: steps grow with the time since, and
// shrink with the time until then. The shortest are those over which the force brings about,
// k |δ'|^p h^(p+1), less than the precision of the momentum m |δ'|. kApproach: a share below 1 of
// the time until the release, chosen on bouncing balls alone.
double NormalPoint::longestStep(const ContactParameters& c, double mass, double precision) const {
  constexpr double kApproach = 0.7;
  const double speed = std::abs(rate);
  if (c.exponent == 1 || !(speed > 0)) return std::numeric_limits<double>::infinity();
  const double shortest = std::pow(precision * mass * std::pow(speed, 1 - c.exponent) / c.stiffness,
                                   1 / (c.exponent + 1));
  return std::max(shortest, (rate > 0 ? 1 : kApproach) * depth / speed);
}

void checkParameters(const ContactParameters& c) {
  const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
  const auto notNegative = [](double x) { return x >= 0 && std::isfinite(x); };
  requireConstant(positive(c.stiffness), "stiffness must be > 0 N/m^p", c.stiffness);
  requireConstant(c.exponent >= 1 && std::isfinite(c.exponent), "exponent must be >= 1",
                  c.exponent);
  requireConstant(notNegative(c.dissipation), "dissipation must be >= 0 s/m", c.dissipation);
  requireConstant(notNegative(c.friction), "friction must be >= 0", c.friction);
  requireConstant(positive(c.breakaway), "breakaway must be > 0 m", c.breakaway);
  requireConstant(notNegative(c.rolling_friction), "rolling_friction must be >= 0 m",
                  c.rolling_friction);
}

}  // namespace rigid_body_sim
