#include <cmath>

#include "sections.hpp"
#include "setting_text.hpp"
#include "support/body_families.hpp"

namespace rigid_body_sim::extremes {
namespace {

const Vector3d kDirection = Vector3d(2, 3, 6) / 7;

/// One body of 1 kg, turning at w_P [rad/s], flying at 1 m/s.
test::Bench spinning(const Vector3d& I, const Vector3d& w_P) {
  test::Bench bench;
  bench.add(test::principalBody("body", 1, I),
            test::tumbling({0.6, 0, 0.8}, w_P, Quaterniond(1, 2, -3, 4).normalized()));
  return bench;
}

const Vector3d kMoments(1, 2, 2.5);

void measureFree(const Cell& cell, const Names& integrators, const test::Bench& bench,
                 const Run& run, Cells& cells, Truth truth = Truth::series) {
  measureAll(cell, integrators, bench, run, freeEnds(bench, run.duration(), truth), cells);
}

/// Ten seconds of a body that turns at 1 rad/s.
Cells shapes(const std::string& section, const Names& integrators,
             const std::vector<std::pair<double, Vector3d>>& moments) {
  Cells cells;
  for (const auto& [setting, I] : moments)
    measureFree({section, settingText(setting), ""}, integrators, spinning(I, kDirection),
                {0.01, 1000}, cells);
  return cells;
}

}  // namespace

Cells needles(const Names& integrators) {
  std::vector<std::pair<double, Vector3d>> moments;
  for (int power = 0; power <= 12; power += 2) {
    const double thin = std::pow(10.0, -power);
    moments.emplace_back(1 / thin, momentsOf(1, 0.6 * thin, 0.4 * thin));
  }
  return shapes("needle", integrators, moments);
}

Cells plates(const Names& integrators) {
  std::vector<std::pair<double, Vector3d>> moments;
  for (double thickness : {1e-3, 1e-6, 1e-9, 1e-12, 1e-15, 0.0})
    moments.emplace_back(thickness, momentsOf(1, 0.4, thickness));
  return shapes("plate", integrators, moments);
}

Cells nearSpheres(const Names& integrators) {
  std::vector<std::pair<double, Vector3d>> moments;
  for (double apart : {0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3})
    moments.emplace_back(apart, momentsOf(1, 1 + 0.4 * apart, 1 + apart));
  return shapes("sphere", integrators, moments);
}

Cells nearlySymmetric(const Names& integrators) {
  std::vector<std::pair<double, Vector3d>> moments;
  for (double apart : {0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3})
    moments.emplace_back(apart, momentsOf(0.3, 1, 1 + apart));
  return shapes("two_equal", integrators, moments);
}

Cells spins(const Names& integrators, const Sizes& sizes) {
  Cells cells;
  for (double spin : sizes) {
    const Truth truth = spin > 1e3 ? Truth::closed_form : Truth::series;
    measureFree({"spin", settingText(spin), ""}, integrators, spinning(kMoments, spin * kDirection),
                {1e-3, 100}, cells, truth);
  }
  return cells;
}

Cells steps(const Names& integrators) {
  Cells cells;
  for (double step : {1e-9, 1e-6, 1e-3, 1e-1, 1.0, 10.0})
    measureFree({"step", settingText(step), ""}, integrators, spinning(kMoments, kDirection),
                {step, 1000}, cells);
  return cells;
}

Cells turns(const Names& integrators, const Sizes& sizes) {
  Cells cells;
  for (double turn : sizes)
    measureFree({"turn", settingText(turn), ""}, integrators, spinning(kMoments, kDirection),
                {turn, 200}, cells, turn > 100 ? Truth::closed_form : Truth::series);
  return cells;
}

Cells separatrix(const Names& integrators) {
  // m₁² I21/I1 = m₃² I32/I3, in numbers of few bits: exactly. What is off grows e^(5.3 t/s).
  Cells cells;
  for (double off : {0.0, 1e-15, 1e-9, 1e-3}) {
    test::Bench bench = spinning({0.375, 0.75, 1}, kDirection);
    BodyState& start = bench.initial.bodies[0];
    start.L_P = {1.75 + off, -7, 3.5};
    start.L_W = rotate(start.q_WP, start.L_P);
    measureFree({"separatrix", settingText(off), ""}, integrators, bench, {5e-3, 1000}, cells,
                Truth::quad_series);
  }
  return cells;
}

Cells positions(const Names& integrators) {
  Cells cells;
  for (double place : {0.0, 1e6, 1e9, 1e12, 1e15, 1e300}) {
    // the state is set apart from its frame, whose place would round the velocity's doing away
    test::Bench bench = spinning(kMoments, kDirection);
    bench.initial.bodies[0].x_W = {place, -place, 0};
    bench.initial.bodies[0].p_W = {1e-3, 0, 1e-3};
    measureFree({"position", settingText(place), ""}, integrators, bench, {1e-3, 1000}, cells);
  }
  return cells;
}

Cells growth(const std::string& integrator, std::int64_t most_steps) {
  const double time_step = 0.01;
  const test::Bench bench = spinning(kMoments, kDirection);
  Simulation simulation = bench.simulation(integrator, time_step);
  Cells cells;
  for (std::int64_t mark = 100; mark <= most_steps; mark *= 10) {
    while (simulation.steps() < mark) simulation.step();
    Cell cell{"growth", settingText(static_cast<double>(mark)), integrator};
    compare(bench, simulation.state(), freeEnds(bench, simulation.time(), Truth::closed_form),
            cell);
    cells.push_back(cell);
  }
  return cells;
}

}  // namespace rigid_body_sim::extremes
