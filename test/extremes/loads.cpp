#include <cmath>
#include <random>

#include "sections.hpp"
#include "setting_text.hpp"

namespace rigid_body_sim::extremes {
namespace {

const Vector3d kBoxMoments(1, 2, 2.5);

PointWrench worldForce(const Vector3d& force, const Vector3d& point = Vector3d::Zero()) {
  PointWrench push;
  push.force = force;
  push.point = point;
  return push;
}

test::Bench tumblingBody() {
  test::Bench bench;
  bench.add(test::principalBody("body", 1, kBoxMoments),
            test::tumbling({0.6, 0, 0.8}, Vector3d(2, 3, 6) / 7));
  return bench;
}

/// What the forces of a bench of one body of 1 kg at its centre of mass amount to.
Ends endsUnder(test::Bench bench, const Vector3d& force, const Run& run) {
  bench.world.wrenches.clear();
  bench.world.g_W = force;
  return freeEnds(bench, run.duration(), Truth::series);
}

}  // namespace

Cells masses(const Names& integrators) {
  Cells cells;
  for (double scale : {1e-12, 1e-6, 1.0, 1e6, 1e12}) {
    test::Bench bench = test::pushedBox(kWorld, 0, scale);
    Body& box = bench.world.bodies[0];
    box = test::principalBody(box.name, scale * box.mass, scale * box.I);
    BodyState& start = bench.initial.bodies[0];
    start.p_W *= scale;
    start.L_W *= scale;
    start.L_P *= scale;
    const Run run{1e-3, 1000};
    measureAll({"mass", settingText(scale), ""}, integrators, bench, run,
               referenceEnds(bench, run.duration()), cells);
  }
  return cells;
}

Cells centralForces(const Names& integrators) {
  Cells cells;
  for (double size : {1e-300, 1e-100, 1.0, 1e100, 1e300}) {
    test::Bench bench = tumblingBody();
    bench.world.wrenches.push_back(worldForce({0, size, 0}));
    const Run run{1e-3, 100};
    measureAll({"force", settingText(size), ""}, integrators, bench, run,
               endsUnder(bench, {0, size, 0}, run), cells);
  }
  return cells;
}

Cells offCentreForces(const Names& integrators, const Sizes& sizes) {
  Cells cells;
  for (double size : sizes) {
    test::Bench bench = tumblingBody();
    bench.world.wrenches.push_back(worldForce({0, size, 0}, {0.3, -0.1, 0.05}));
    const Run run{1e-3, 100};
    // beyond, every integrator stops
    const Ends truth = size > 1e5 ? Ends() : referenceEnds(bench, run.duration());
    measureAll({"lever", settingText(size), ""}, integrators, bench, run, truth, cells);
  }
  return cells;
}

Cells conflicts(const Names& integrators) {
  Cells cells;
  for (double size : {1e3, 1e20, 1e100, 1e300, 1.5e308}) {
    test::Bench bench = tumblingBody();
    for (double force : {size, 1.0, size / 3, -size, -size / 3})
      bench.world.wrenches.push_back(worldForce({0, force, 0}));
    const Run run{1e-3, 100};
    measureAll({"conflict", settingText(size), ""}, integrators, bench, run,
               endsUnder(bench, {0, 1, 0}, run), cells);
  }
  return cells;
}

Cells arms(const Names& integrators) {
  Cells cells;
  for (double length : {1.0, 1e3, 1e6, 1e9, 1e12}) {
    test::Bench bench = tumblingBody();
    bench.world.wrenches.push_back(
        worldForce({0, 1 / length, 0}, length * Vector3d(0.3, -0.1, 0.05)));
    const Run run{1e-3, 1000};
    measureAll({"arm", settingText(length), ""}, integrators, bench, run,
               referenceEnds(bench, run.duration()), cells);
  }
  return cells;
}

Cells farPulls(const Names& integrators) {
  const auto pulledAt = [](double place) {
    test::Bench bench = tumblingBody();
    bench.initial.bodies[0].x_W = {place, 0, 0};
    PointWrench pull = worldForce({0, 1, 0.5}, {place + 1, 0.25, 0});
    pull.point_frame = kWorld;
    bench.world.wrenches.push_back(pull);
    return bench;
  };
  // the same as at the origin, where the reference holds more digits; 1e12 + 1 is exact
  const Run run{1e-3, 1000};
  const Ends truth = referenceEnds(pulledAt(0), run.duration());
  Cells cells;
  for (double place : {0.0, 1e3, 1e6, 1e9, 1e12})
    measureAll({"far_pull", settingText(place), ""}, integrators, pulledAt(place), run, truth,
               cells);
  return cells;
}

Cells throughZero(const Names& integrators) {
  Cells cells;
  // the instant at which L is zero, in steps: on a step's end, and within a step
  for (double instant : {500.0, 499.7}) {
    test::Bench bench = tumblingBody();
    const Run run{1e-3, 1000};
    PointWrench brake;
    brake.torque = -bench.initial.bodies[0].L_W / (instant * run.time_step);
    bench.world.wrenches.push_back(brake);
    measureAll({"through_zero", settingText(instant), ""}, integrators, bench, run,
               referenceEnds(bench, run.duration()), cells);
  }
  return cells;
}

Cells springs(const Names& integrators, const Sizes& sizes) {
  Cells cells;
  for (double stiffness : sizes) {
    test::Bench bench = tumblingBody();
    bench.initial.bodies[0].p_W.setZero();
    const Vector3d start(0.5, -1, 0.25);
    bench.initial.bodies[0].x_W = start;
    const Vector3d origin = Vector3d::Zero();
    bench.addSpring({0, origin}, {kWorld, origin}, {stiffness, 0, 0});
    const Run run{1e-3, 10};
    // x = x₀ cos Ωt of a body of 1 kg, Ω = √stiffness
    Ends truth = freeEnds(bench, run.duration(), Truth::series);
    const reference::Real rate = std::sqrt(static_cast<reference::Real>(stiffness));
    const reference::Real angle = rate * static_cast<reference::Real>(run.duration());
    const reference::Real half = std::sin(angle / 2);
    truth.motions[0].x = -2 * half * half * start.cast<reference::Real>();
    truth.motions[0].v = -rate * std::sin(angle) * start.cast<reference::Real>();
    measureAll({"spring", settingText(stiffness), ""}, integrators, bench, run, truth, cells);
  }
  return cells;
}

Cells tolerances() {
  test::Bench linked;
  const Body box = test::principalBody("box", 1, kBoxMoments);
  linked.add(box, test::tumbling({0, 0, 0}, {1, 0.5, -0.3}));
  linked.add(box, test::tumbling({0.3, 0, 0.2}, {0.2, -1, 0.1}));
  linked.initial.bodies[1].x_W = {2, 0, 0};
  linked.addSpring({0, {0.3, 0, 0.2}}, {1, {-0.3, 0.1, 0}}, {5, 0, 1});
  test::Bench pushed = test::pushedBox(kWorld, 0);
  const Run run{1e-2, 100};
  const Ends linked_end = referenceEnds(linked, run.duration());
  const Ends pushed_end = referenceEnds(pushed, run.duration());
  Cells cells;
  for (double tolerance : {1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 1.0}) {
    for (test::Bench* bench : {&linked, &pushed}) {
      bench->world.solver.tolerance = tolerance;
      bench->world.solver.tolerance_stated = true;
      bench->world.solver.horizon = run.duration();
    }
    Cell cell{"tolerance", settingText(tolerance), "auto"};
    Cell stepped = measure(cell, linked, run, linked_end);
    stepped.integrator = "auto, spring";
    Cell solved = measure(cell, pushed, run, pushed_end);
    solved.integrator = "auto, wrench";
    cells.insert(cells.end(), {stepped, solved});
  }
  return cells;
}

Cells crowds(const Names& integrators, std::size_t bodies) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  test::Bench bench;
  bench.world.g_W = {0, 0, -9.81};
  for (std::size_t i = 0; i < bodies; ++i)
    bench.add(test::principalBody("body", 1, kBoxMoments),
              test::tumbling({normal(random), normal(random), normal(random)},
                             {normal(random), normal(random), normal(random)}));
  const Run run{1e-2, 10};
  Cells cells;
  measureAll({"crowd", settingText(static_cast<double>(bodies)), ""}, integrators, bench, run,
             freeEnds(bench, run.duration(), Truth::closed_form), cells);
  return cells;
}

}  // namespace rigid_body_sim::extremes
