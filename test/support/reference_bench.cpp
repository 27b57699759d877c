#include "support/reference_bench.hpp"

#include <algorithm>
#include <vector>

namespace rigid_body_sim::test {

namespace {

reference::Load loadOf(const PointWrench& applied, const reference::Motions& m) {
  using reference::Vector;
  const auto indexOf = [&](std::size_t frame) { return frame == kOwnBody ? applied.body : frame; };
  const auto turned = [&](const Vector3d& v) -> Vector {
    const Vector wide = v.cast<reference::Real>();
    return applied.axes == kWorld ? wide : Vector(m[indexOf(applied.axes)].R() * wide);
  };
  const Vector point = applied.point.cast<reference::Real>();
  const std::size_t holder = indexOf(applied.point_frame);
  const Vector r_W = holder == kWorld ? point : Vector(m[holder].x + m[holder].R() * point);
  reference::Load load;
  load.f_W = turned(applied.force);
  load.tau_W = (r_W - m[applied.body].x).cross(load.f_W) + turned(applied.torque);
  return load;
}

}  // namespace

reference::Motions referenceRun(const Bench& bench, double duration) {
  std::vector<double> instants{duration};
  for (const PointWrench& applied : bench.world.wrenches)
    for (double t : {applied.start, applied.end})
      if (t > 0 && t < duration) instants.push_back(t);
  std::sort(instants.begin(), instants.end());

  reference::Motions motions;
  for (std::size_t i = 0; i < bench.world.bodies.size(); ++i)
    motions.push_back(reference::toMotion(bench.world.bodies[i], bench.initial.bodies[i]));
  double t = 0;
  for (double next : instants) {
    if (!(next > t)) continue;
    const auto wrenches = [&](reference::Real, const reference::Motions& m) {
      reference::Loads loads(m.size());
      for (std::size_t i = 0; i < m.size(); ++i) {
        const Body& body = bench.world.bodies[i];
        loads[i].f_W = reference::Real(body.mass) * bench.world.g_W.cast<reference::Real>();
        const reference::Vector arm_W = m[i].R() * body.com_P.cast<reference::Real>();
        loads[i].tau_W = arm_W.cross(loads[i].f_W);
      }
      for (const PointWrench& applied : bench.world.wrenches) {
        if (applied.start > t || applied.end <= t) continue;
        const reference::Load load = loadOf(applied, m);
        loads[applied.body].f_W += load.f_W;
        loads[applied.body].tau_W += load.tau_W;
      }
      for (const reference::Law& law : bench.reference_laws) law(bench.world.bodies, m, loads);
      for (std::size_t i = 0; i < m.size(); ++i)
        if (bench.world.bodies[i].pivoted) loads[i].f_W.setZero();
      return loads;
    };
    motions = reference::advance(bench.world.bodies, wrenches, motions, t,
                                 static_cast<reference::Real>(next) - t, 0.05L);
    t = next;
  }
  return motions;
}

MotionErrors motionErrors(const State& state, const reference::Motions& motions) {
  MotionErrors worst;
  for (std::size_t i = 0; i < motions.size(); ++i) {
    const BodyState& s = state.bodies[i];
    const reference::Vector gap =
        s.x_W.cast<reference::Real>() + s.x_low_W.cast<reference::Real>() - motions[i].x;
    worst.attitude =
        std::max(worst.attitude, static_cast<double>(reference::attitudeError(s.q_WP, motions[i])));
    worst.position = std::max(worst.position, static_cast<double>(gap.norm()));
  }
  return worst;
}

}  // namespace rigid_body_sim::test
