#include "math/gauss_legendre.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <cstddef>

#include "math/wide.hpp"

namespace rigid_body_sim {
namespace {

struct Legendre {
  long double value;
  long double slope;
};

/// P_n at |x| < 1 by its recurrence, and P_n' = n (x P_n − P_{n−1})/(x² − 1).
Legendre legendre(int n, long double x) {
  long double last = 1, value = x;
  for (int k = 2; k <= n; ++k) {
    const long double next = ((2 * k - 1) * x * value - (k - 1) * last) / k;
    last = value;
    value = next;
  }
  return {value, n * (x * value - last) / (x * x - 1)};
}

/// The nodes are the roots of P_n, by Newton's method from cos π (i + 3/4)/(n + 1/2); the weights
/// on [−1, 1] are 2/((1 − x²) P_n'²). Source: Abramowitz & Stegun 25.4.29, 22.16.6.
std::vector<QuadratureNode> rule(int n) {
  std::vector<QuadratureNode> nodes;
  for (int i = 0; i < n; ++i) {
    long double x = -std::cos(kPi<long double> * (i + 0.75L) / (n + 0.5L));
    for (int k = 0; k < 6; ++k) {
      const Legendre p = legendre(n, x);
      x -= p.value / p.slope;
    }
    const long double slope = legendre(n, x).slope;
    nodes.push_back(
        {static_cast<double>((1 + x) / 2), static_cast<double>(1 / ((1 - x * x) * slope * slope))});
  }
  return nodes;
}

}  // namespace

const std::vector<QuadratureNode>& gaussLegendre(int nodes) {
  static const std::array<std::vector<QuadratureNode>, kMaxGaussNodes> rules = [] {
    std::array<std::vector<QuadratureNode>, kMaxGaussNodes> all;
    for (int n = 1; n <= kMaxGaussNodes; ++n) all[static_cast<std::size_t>(n - 1)] = rule(n);
    return all;
  }();
  assert(1 <= nodes && nodes <= kMaxGaussNodes);
  return rules[static_cast<std::size_t>(nodes - 1)];
}

}  // namespace rigid_body_sim
