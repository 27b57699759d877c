#include "tools/plot/figures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <rigid_body_sim/math/rotation.hpp>

#include "math/wide.hpp"
#include "tools/plot/attitude_angles.hpp"

namespace rigid_body_sim {
namespace {

constexpr double kDegrees = 180 / kPi<double>;

using Axes = std::array<const char*, 3>;
constexpr Axes kAxes{"x", "y", "z"};

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// What counts as a change of a vector: the greatest that there is, or, where that is rounding, the
/// greatest number.
class ChangeScale {
 public:
  void take(const std::vector<double>& values) {
    if (values.empty()) return;
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    change_ = std::max(change_, *high - *low);
    greatest_ = std::max({greatest_, std::abs(*low), std::abs(*high)});
  }
  double value() const {
    constexpr double kRounding = 1e-12;
    return change_ > kRounding * greatest_ ? change_ : greatest_;
  }

 private:
  double change_ = 0, greatest_ = 0;
};

/// [s] The median interval between instants that differ; zero where there is none.
double usualInterval(const std::vector<double>& t) {
  std::vector<double> intervals;
  for (std::size_t k = 1; k < t.size(); ++k)
    if (t[k] > t[k - 1]) intervals.push_back(t[k] - t[k - 1]);
  if (intervals.empty()) return 0;
  const auto middle = intervals.begin() + static_cast<std::ptrdiff_t>(intervals.size() / 2);
  std::nth_element(intervals.begin(), middle, intervals.end());
  return *middle;
}

void addPoint(double t, const Vector3d& v, std::array<Curve, 3>& curves) {
  for (int i = 0; i < 3; ++i) {
    curves[static_cast<std::size_t>(i)].t.push_back(t);
    curves[static_cast<std::size_t>(i)].y.push_back(v[i]);
  }
}

/// What three panels show of each body: a vector for each of its samples, asked for in their order.
template <std::size_t N>
using VectorOf = std::function<std::function<Vector3d(std::size_t)>(const Samples<N>&)>;

/// A panel for each axis, a curve for each body. axes and unit: for the labels. vector_of: makes,
/// for each body anew, what gives the vector of a sample.
template <std::size_t N>
Figure vectorFigure(const std::string& name, const std::string& title, const ByBody<N>& all,
                    const std::vector<std::string>& bodies, const Axes& axes,
                    const std::string& unit, const VectorOf<N>& vector_of) {
  Figure figure{name, title, std::vector<Panel>(3)};
  ChangeScale scale;
  for (const BodySamples<N>& each : all.all()) {
    if (!contains(bodies, each.body)) continue;
    std::array<Curve, 3> curves{Curve{each.body}, Curve{each.body}, Curve{each.body}};
    for (Curve& curve : curves) curve.interval = usualInterval(each.samples.t);
    const auto vector = vector_of(each.samples);
    for (std::size_t k = 0; k < each.samples.t.size(); ++k)
      addPoint(each.samples.t[k], vector(k), curves);
    for (std::size_t i = 0; i < 3; ++i) {
      scale.take(curves[i].y);
      figure.panels[i].curves.push_back(std::move(curves[i]));
    }
  }
  for (std::size_t i = 0; i < 3; ++i) {
    figure.panels[i].axis = std::string(axes[i]) + " [" + unit + "]";
    figure.panels[i].scale = scale.value();
  }
  return figure;
}

/// Three numbers of a row, from `begin` on.
template <std::size_t N>
VectorOf<N> numbersFrom(std::size_t begin) {
  return [begin](const Samples<N>& samples) {
    return [begin, &samples](std::size_t k) { return vectorAt(begin, samples.rows[k]); };
  };
}

Quaterniond attitudeOf(const std::array<double, 13>& m) {
  return Quaterniond(m[6], m[3], m[4], m[5]);
}

std::function<Vector3d(std::size_t)> ratesOf(const Samples<13>& samples) {
  return [&samples](std::size_t k) {
    const std::array<double, 13>& m = samples.rows[k];
    return rotateBack(attitudeOf(m), vectorAt(10, m));
  };
}

/// Whether the body did not turn from sample k - 1 to sample k: it was away between, was put into
/// another state, or time went back. gap: [s] beyond which samples are missing.
bool isPutElsewhere(const Samples<13>& samples, std::size_t k, double gap) {
  const double dt = samples.t[k] - samples.t[k - 1];
  if (dt < 0 || dt > gap) return true;
  const std::array<double, 13>&a = samples.rows[k - 1], &b = samples.rows[k];
  const double rate = std::max(vectorAt(10, a).norm(), vectorAt(10, b).norm());
  constexpr double kMargin = 2, kRounding = 1e-6;  // of rates that vary between samples; [rad]
  return angleBetween(attitudeOf(a), attitudeOf(b)) > kMargin * rate * dt + kRounding;
}

std::function<Vector3d(std::size_t)> anglesOf(const Samples<13>& samples) {
  const double gap = 4 * usualInterval(samples.t);  // where the curve breaks, too
  return [&samples, gap, angles = AttitudeAngles()](std::size_t k) mutable {
    if (k > 0 && isPutElsewhere(samples, k, gap)) angles.startAnew();
    return Vector3d(kDegrees * angles.next(attitudeOf(samples.rows[k])));
  };
}

void addMotion(const RunData& run, const std::vector<std::string>& bodies,
               std::vector<Figure>& figures) {
  const auto add = [&](const char* name, const char* title, const Axes& axes, const char* unit,
                       const VectorOf<13>& vector_of) {
    figures.push_back(vectorFigure<13>(name, title, run.motion, bodies, axes, unit, vector_of));
  };
  add("position", "Position of the body frame in the world", kAxes, "m", numbersFrom<13>(0));
  add("attitude", "Attitude: roll, pitch and yaw, without jumps", {"roll", "pitch", "yaw"}, "deg",
      anglesOf);
  add("velocity", "Velocity of the origin of the body frame, world axes", kAxes, "m/s",
      numbersFrom<13>(7));
  add("rates", "Angular velocity, axes of the body", kAxes, "rad/s", ratesOf);
}

bool isZero(const Figure& figure) {
  for (const Panel& panel : figure.panels)
    for (const Curve& curve : panel.curves)
      if (std::any_of(curve.y.begin(), curve.y.end(), [](double y) { return y != 0; }))
        return false;
  return true;
}

void addForces(const RunData& run, const std::vector<std::string>& bodies,
               std::vector<Figure>& figures) {
  const auto add = [&](Figure figure) {
    if (!isZero(figure)) figures.push_back(std::move(figure));
  };
  const auto six = [&](const char* name, const char* title, const ByBody<6>& all,
                       std::size_t begin) {
    add(vectorFigure<6>(name, title, all, bodies, kAxes, begin == 0 ? "N" : "N m",
                        numbersFrom<6>(begin)));
  };
  six("force", "Force on the body: all but uniform gravity, world axes", run.loads, 0);
  six("torque", "Torque on the body about its centre of mass or its pivot, world axes", run.loads,
      3);
  six("applied_force", "Applied force, axes of the body", run.applied, 0);
  six("applied_torque", "Applied torque about the centre of mass, axes of the body", run.applied,
      3);
  add(vectorFigure<3>("contact_force", "Force of all contacts of the body, world axes", run.contact,
                      bodies, kAxes, "N", numbersFrom<3>(0)));
  add(vectorFigure<3>("pivot_force", "Force of the pivot on the body, axes of the body", run.pivot,
                      bodies, kAxes, "N", numbersFrom<3>(0)));
}

}  // namespace

std::vector<Figure> figuresOf(const RunData& run, const std::vector<std::string>& bodies) {
  std::vector<Figure> figures;
  if (!run.motion.empty()) addMotion(run, bodies, figures);
  addForces(run, bodies, figures);
  for (Figure& figure : balanceFigures(run)) figures.push_back(std::move(figure));
  for (Figure& figure : figures) figure.title += ": " + run.name;
  return figures;
}

}  // namespace rigid_body_sim
