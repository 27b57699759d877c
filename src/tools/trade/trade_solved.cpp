#include "tools/trade/trade_solved.hpp"

#include <algorithm>

#include <rigid_body_sim/dynamics/simulation.hpp>

#include "dynamics/methods/pivots.hpp"
#include "dynamics/rotation/free_top.hpp"
#include "dynamics/step_too_long.hpp"
#include "dynamics/taylor/taylor_segment.hpp"
#include "dynamics/wrenches/wrench_schedule.hpp"

namespace rigid_body_sim {
namespace {

using Fine = BodyStateT<long double>;

Fine fine(const BodyState& s) {
  Fine f;
  f.x_W = s.x_W.cast<long double>();
  f.x_low_W = s.x_low_W.cast<long double>();
  f.q_WP = s.q_WP.cast<long double>().normalized();
  f.p_W = s.p_W.cast<long double>();
  f.L_P = s.L_P.cast<long double>();
  f.L_W = rotate(f.q_WP, f.L_P);  // of the two accounts one, so that both tracks start alike
  return f;
}

BodyState rounded(const Fine& f) {
  BodyState s;
  const Vector3<long double> x = f.x_W + f.x_low_W;
  s.x_W = x.cast<double>();
  s.x_low_W = (x - s.x_W.cast<long double>()).cast<double>();
  s.q_WP = f.q_WP.cast<double>();
  s.p_W = f.p_W.cast<double>();
  s.L_W = f.L_W.cast<double>();
  s.L_P = f.L_P.cast<double>();
  return s;
}

HeldWrench heldNow(const Body& body, const Vector3d& g_W, const WrenchSchedule& schedule) {
  HeldWrenchSum sum;
  for (const PointWrench& wrench : schedule.active()) sum.add(wrench);
  System::Pivot pivot{0, g_W};
  return body.pivoted ? heldOnPivot(body, std::move(sum), pivot) : sum.sum();
}

/// Advances from t to t_end, split at every start and end of a wrench.
Fine advanced(const Body& body, const Vector3d& g_W, WrenchSchedule& schedule, Fine state, double t,
              double t_end) {
  schedule.advanceTo(t);
  const Vector3d fall_W = body.pivoted ? Vector3d::Zero() : g_W;
  while (t < t_end) {
    const double t_next = std::min(t_end, schedule.nextEvent());
    state = advanceTaylor<long double>(body, heldNow(body, g_W, schedule), fall_W, state,
                                       static_cast<long double>(t_next) - t);
    t = t_next;
    schedule.advanceTo(t);
  }
  return state;
}

/// States at equal intervals; fill(body, track) sets those of a body that moves.
template <class Fill>
std::vector<State> trackOf(const World& world, const State& initial, double duration, int instants,
                           const Fill& fill) {
  std::vector<State> track(static_cast<std::size_t>(instants) + 1, initial);
  for (std::size_t k = 1; k < track.size(); ++k)
    track[k].t = duration * static_cast<double>(k) / instants;
  for (std::size_t i = 0; i < world.bodies.size(); ++i)
    if (moves(world.bodies[i])) fill(i, track);
  return track;
}

}  // namespace

std::vector<State> seriesTrack(const World& world, const State& initial, double duration,
                               int instants) {
  return trackOf(world, initial, duration, instants, [&](std::size_t i, std::vector<State>& track) {
    WrenchSchedule schedule;
    for (const PointWrench& wrench : world.wrenches)
      if (wrench.body == i) schedule.put("", wrench, 0);
    Fine state = fine(initial.bodies[i]);
    for (std::size_t k = 1; k < track.size(); ++k) {
      try {
        state = advanced(world.bodies[i], world.g_W, schedule, state, track[k - 1].t, track[k].t);
      } catch (const StepTooLong& reason) {
        throw SimulationDiverged(track[k - 1].t, world.bodies[i].name, reason.what());
      }
      track[k].bodies[i] = rounded(state);
    }
  });
}

std::vector<State> freeTrack(const World& world, const State& initial, double duration,
                             int instants) {
  return trackOf(world, initial, duration, instants, [&](std::size_t i, std::vector<State>& track) {
    const Body& body = world.bodies[i];
    const Fine start = fine(initial.bodies[i]);
    const auto g_W = world.g_W.cast<long double>();
    const FreeRotation<long double> rotation =
        FreeTop<long double>(body.I.cast<long double>()).from(start.q_WP, start.L_P, start.L_W);
    for (std::size_t k = 1; k < track.size(); ++k) {
      const long double t = track[k].t;
      const RotationState<long double> turned = rotation.at(t);
      Fine state = start;
      state.x_low_W += start.p_W * (t / body.mass) + g_W * (t * t / 2);
      state.p_W += body.mass * t * g_W;
      state.q_WP = turned.q_WP;
      state.L_P = turned.L_P;
      track[k].bodies[i] = rounded(state);
    }
  });
}

}  // namespace rigid_body_sim
