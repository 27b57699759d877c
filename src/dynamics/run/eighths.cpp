#include "dynamics/run/eighths.hpp"

#include <algorithm>
#include <cmath>

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

/// [eighths] Eight in each eighth; near the ends ever closer to them, so that a minimum beside an
/// end lies between two places, too.
EighthsInterpolant::Places EighthsInterpolant::placesToLook() {
  constexpr double kCloser = 4;
  Places places{};
  std::size_t place = 1;  // the first is the start
  for (std::size_t k = kLooksBesideAnEnd; k > 0; --k)
    places[place++] = std::pow(kCloser, -static_cast<double>(k)) / 8;
  for (std::size_t look = 1; look <= 8 * kEighths / 2; ++look)
    places[place++] = static_cast<double>(look) / 8;
  for (std::size_t mirrored = 0; place < kLooks; ++place, ++mirrored)
    places[place] = kEighths - places[kLooks - 1 - place];
  return places;
}

EighthsInterpolant::EighthsInterpolant(const Values& values) {
  static const auto kWeights = [] {
    std::array<Weights, kLooks> all;
    const Places places = placesToLook();
    std::transform(places.begin(), places.end(), all.begin(), weightsAt);
    return all;
  }();
  for (std::size_t look = 0; look < kLooks; ++look) {
    values_[look] = 0;
    for (std::size_t k = 0; k < values.size(); ++k) values_[look] += kWeights[look][k] * values[k];
  }
}

std::vector<PointOfCurve> EighthsInterpolant::minima() const {
  static const Places kPlaces = placesToLook();
  std::vector<PointOfCurve> found;
  for (std::size_t look = 1; look + 1 < kLooks; ++look) {
    const double before = values_[look - 1], here = values_[look], after = values_[look + 1];
    if (here <= before && here <= after && (here < before || here < after))
      found.push_back(
          vertexOf({kPlaces[look - 1], before}, {kPlaces[look], here}, {kPlaces[look + 1], after}));
  }
  return found;
}

}  // namespace rigid_body_sim
