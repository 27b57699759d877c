#include "dynamics/run/eighths.hpp"

namespace rigid_body_sim {
namespace {

using Weights = EighthsInterpolant::Values;

/// Lagrange's polynomials at a place, in eighths.
Weights weightsAt(double eighths) {
  Weights weights;
  for (std::size_t k = 0; k < weights.size(); ++k) {
    weights[k] = 1;
    for (std::size_t j = 0; j < weights.size(); ++j)
      if (j != k)
        weights[k] *=
            (eighths - static_cast<double>(j)) / (static_cast<double>(k) - static_cast<double>(j));
  }
  return weights;
}

}  // namespace

EighthsInterpolant::EighthsInterpolant(const Values& values) {
  static const auto kWeights = [] {
    std::array<Weights, kEighths * kLooks + 1> all;
    for (std::size_t look = 0; look < all.size(); ++look)
      all[look] = weightsAt(static_cast<double>(look) / kLooks);
    return all;
  }();
  for (std::size_t look = 0; look < values_.size(); ++look) {
    values_[look] = 0;
    for (std::size_t k = 0; k < values.size(); ++k) values_[look] += kWeights[look][k] * values[k];
  }
}

/// By the vertices of parabolas through neighbours.
std::vector<EighthsInterpolant::Minimum> EighthsInterpolant::minima() const {
  std::vector<Minimum> found;
  for (std::size_t look = 1; look + 1 < values_.size(); ++look) {
    const double before = values_[look - 1], here = values_[look], after = values_[look + 1];
    if (!(here <= before && here <= after && before + after > 2 * here)) continue;
    const double vertex = 0.5 * (before - after) / (before + after - 2 * here);
    found.push_back(
        {(static_cast<double>(look) + vertex) / kLooks, here - 0.25 * (before - after) * vertex});
  }
  return found;
}

}  // namespace rigid_body_sim
