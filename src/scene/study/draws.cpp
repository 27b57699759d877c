#include "scene/study/draws.hpp"

#include <algorithm>
#include <cmath>

#include <boost/math/special_functions/erf.hpp>

#include <rigid_body_sim/math/rotation.hpp>

#include "math/counter_draws.hpp"

namespace rigid_body_sim {
namespace {

/// The inverse of the normal distribution's cumulative function; 0 < u < 1.
double normalQuantile(double u) { return -std::sqrt(2.0) * boost::math::erfc_inv(2 * u); }

SceneValue orientationValue(const Quaterniond& q) {
  return SceneValue::of({q.x(), q.y(), q.z(), q.w()});
}

Quaterniond orientationIn(const SceneValue& value) {
  const auto component = [&](std::size_t i) { return value.words[i].number.value(); };
  return {component(3), component(0), component(1), component(2)};
}

/// Uniform over all attitudes. Source: Shoemake, "Uniform random rotations", Graphics Gems III.
Quaterniond uniformRotation(double u0, double u1, double u2) {
  const double a = std::sqrt(1 - u0), b = std::sqrt(u0);
  const double t1 = 2 * kPi<double> * u1, t2 = 2 * kPi<double> * u2;
  return Quaterniond(b * std::cos(t2), a * std::sin(t1), a * std::cos(t1), b * std::sin(t2));
}

}  // namespace

std::uint64_t permuted(std::uint64_t key, std::uint64_t place, std::uint64_t size) {
  unsigned half = 1;  // bits
  while ((std::uint64_t{1} << (2 * half)) < size) ++half;
  const std::uint64_t mask = (std::uint64_t{1} << half) - 1;
  do {
    std::uint64_t left = place >> half, right = place & mask;
    for (std::uint64_t round = 0; round < 4; ++round) {
      const std::uint64_t mixed = left ^ (mixBits(key ^ (right | round << 62)) & mask);
      left = right;
      right = mixed;
    }
    place = left << half | right;
  } while (place >= size);
  return place;
}

Draws::Draws(const Study& study) : study_(study), runs_(study.runs * gridSize(study)) {
  std::int64_t stride = gridSize(study);
  for (const Varied& varied : study.vary) {
    Path path;
    path.key = drawKey(study.seed, varied.path);
    if (const auto* grid = std::get_if<GridDistribution>(&varied.distribution))
      path.stride = stride /= static_cast<std::int64_t>(grid->values.size());
    paths_.push_back(path);
  }
}

double Draws::uniform(std::size_t index, std::int64_t run, std::uint32_t component) const {
  constexpr double kHalfUnit = 0.5 / 9007199254740992;  // so that 0 does not come
  const std::uint64_t key = paths_[index].key;
  const double u =
      uniformDraws(key, static_cast<std::uint64_t>(run), component, 0).below_one + kHalfUnit;
  if (!study_.latin_hypercube) return std::min(u, 1 - 2 * kHalfUnit);
  const auto runs = static_cast<std::uint64_t>(runs_);
  const std::uint64_t stratum =
      permuted(mixBits(key ^ component), static_cast<std::uint64_t>(run), runs);
  return std::min((static_cast<double>(stratum) + u) / static_cast<double>(runs),
                  1 - 2 * kHalfUnit);
}

double Draws::normal(std::size_t index, std::int64_t run, std::uint32_t component) const {
  if (study_.latin_hypercube) return normalQuantile(uniform(index, run, component));
  const PolarDraw draw =
      polarDraw(uniformDraws(paths_[index].key, static_cast<std::uint64_t>(run), component, 0));
  return draw.radius * std::cos(draw.angle);
}

SceneValue Draws::value(std::size_t index, std::int64_t run, const SceneValue& own) const {
  if (const std::optional<double> x = number(index, run)) return SceneValue::of(*x);
  if (const SceneValue* one = named(index, run)) return *one;
  return rotated(index, run, own);
}

std::optional<double> Draws::number(std::size_t index, std::int64_t run) const {
  const Distribution& distribution = study_.vary[index].distribution;
  if (const auto* d = std::get_if<NormalDistribution>(&distribution))
    return d->mean + d->stddev * normal(index, run, 0);
  const auto* d = std::get_if<UniformDistribution>(&distribution);
  if (!d) return std::nullopt;
  const double u = uniform(index, run, 0);
  return std::min((1 - u) * d->low + u * d->high, std::nextafter(d->high, d->low));
}

const SceneValue* Draws::named(std::size_t index, std::int64_t run) const {
  const Distribution& distribution = study_.vary[index].distribution;
  if (const auto* d = std::get_if<ListDistribution>(&distribution)) {
    const auto count = static_cast<double>(d->values.size());
    const auto chosen = static_cast<std::size_t>(count * uniform(index, run, 0));
    return &d->values[std::min(chosen, d->values.size() - 1)];
  }
  const auto* d = std::get_if<GridDistribution>(&distribution);
  if (!d) return nullptr;
  const auto count = static_cast<std::int64_t>(d->values.size());
  return &d->values[static_cast<std::size_t>(run / paths_[index].stride % count)];
}

SceneValue Draws::rotated(std::size_t index, std::int64_t run, const SceneValue& own) const {
  const auto& rotation = std::get<RotationDistribution>(study_.vary[index].distribution);
  if (!rotation.stddev)
    return orientationValue(
        uniformRotation(uniform(index, run, 0), uniform(index, run, 1), uniform(index, run, 2)));
  const Vector3d turn(normal(index, run, 0), normal(index, run, 1), normal(index, run, 2));
  const Vector3d v = *rotation.stddev * turn;
  return orientationValue((orientationIn(own) * rotationExp(v)).normalized());
}

}  // namespace rigid_body_sim
