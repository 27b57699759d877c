#include <algorithm>
#include <cmath>
#include <functional>

#include "programs/formatted.hpp"
#include "tools/plot/figures.hpp"

namespace rigid_body_sim {
namespace {

// columns of the balance
enum : std::size_t {
  kEnergy,
  kKinetic,
  kWork,
  kMomentum,
  kAngular = 6,
  kEnergyLeft = 9,
  kMomentumLeft,
  kAngularLeft = 13
};

using BalanceRow = std::array<double, 16>;

Curve curveOf(const std::string& name, const Samples<16>& samples,
              const std::function<double(const BalanceRow&)>& value) {
  Curve curve{name, samples.t, {}};
  for (const BalanceRow& row : samples.rows) curve.y.push_back(value(row));
  return curve;
}

double greatest(const Curve& curve) {
  double most = 0;
  for (const double y : curve.y) most = std::max(most, std::abs(y));
  return most;
}

Panel vectorPanel(const std::string& axis, const Samples<16>& samples, std::size_t begin) {
  Panel panel{"", axis, {}};
  for (std::size_t i = 0; i < 3; ++i)
    panel.curves.push_back(curveOf(std::string(1, "xyz"[i]), samples,
                                   [=](const BalanceRow& row) { return row[begin + i]; }));
  for (const Curve& curve : panel.curves) panel.scale = std::max(panel.scale, greatest(curve));
  return panel;
}

/// "energy: at most 3e-16 J, 1e-17 of the greatest kinetic energy". Of a body that stands still
/// that is rounding, too, and no measure.
std::string leftText(const std::string& what, double most, const char* unit, double scale,
                     const std::string& of) {
  std::string text = what + formatted(": at most %.2g %s", most, unit);
  if (scale > most && most > 0) text += formatted(", %.1g of ", most / scale) + of;
  return text;
}

Figure balanceFigure(const RunData& run) {
  const Samples<16>& samples = run.balance;
  const auto norm = [](std::size_t begin) {
    return [begin](const BalanceRow& row) { return vectorAt(begin, row).norm(); };
  };
  const auto column = [](std::size_t k) { return [k](const BalanceRow& row) { return row[k]; }; };
  const Curve energy = curveOf("", samples, column(kEnergyLeft));
  const Curve momentum = curveOf("", samples, norm(kMomentumLeft));
  const Curve angular = curveOf("", samples, norm(kAngularLeft));
  const double kinetic = run.has_kinetic ? greatest(curveOf("", samples, column(kKinetic))) : 0;
  const double p = greatest(curveOf("", samples, norm(kMomentum)));
  const double L = greatest(curveOf("", samples, norm(kAngular)));
  return {"balance",
          "What work and impulses of all forces do not account for: the error of the computation",
          {{leftText("energy", greatest(energy), "J", kinetic, "the greatest kinetic energy"),
            "energy [J]",
            {energy}},
           {leftText("momentum", greatest(momentum), "kg m/s", p, "the greatest momentum"),
            "momentum [kg m/s]",
            {momentum}},
           {leftText("angular momentum", greatest(angular), "kg m²/s", L, "the greatest"),
            "ang. momentum [kg m²/s]",
            {angular}}}};
}

}  // namespace

std::vector<Figure> balanceFigures(const RunData& run) {
  const Samples<16>& samples = run.balance;
  if (samples.t.empty()) return {};
  Panel energy{"", "energy [J]", {}};
  energy.curves.push_back(
      curveOf("mechanical energy", samples, [](const BalanceRow& row) { return row[kEnergy]; }));
  // row by row: a node's balance starts anew with every reset and every state that is set
  energy.curves.push_back(curveOf("at start + work", samples, [](const BalanceRow& row) {
    return row[kEnergy] - row[kEnergyLeft];
  }));
  energy.curves.back().dashed = true;
  if (run.has_kinetic)
    energy.curves.push_back(
        curveOf("kinetic energy", samples, [](const BalanceRow& row) { return row[kKinetic]; }));
  Panel momentum = vectorPanel("momentum [kg m/s]", samples, kMomentum);
  Panel angular = vectorPanel("ang. momentum [kg m²/s]", samples, kAngular);
  return {{"energy", "Energy of all bodies and force laws", {std::move(energy)}},
          {"momentum",
           "Momentum of all bodies, and angular momentum about the world's origin",
           {std::move(momentum), std::move(angular)}},
          balanceFigure(run)};
}

}  // namespace rigid_body_sim
