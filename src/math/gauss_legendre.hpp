#pragma once

#include <vector>

namespace rigid_body_sim {

/// A place of an integration rule on [0, 1] and its weight.
struct QuadratureNode {
  double place;
  double weight;
};

/// The Gauss–Legendre rule of 1 to kMaxGaussNodes nodes on [0, 1]: exact for polynomials of degree
/// 2n − 1. The weights sum to 1.
const std::vector<QuadratureNode>& gaussLegendre(int nodes);

constexpr int kMaxGaussNodes = 10;

}  // namespace rigid_body_sim
