#include "dynamics/packs/flight_kernels.hpp"

#include <utility>

#include "dynamics/packs/pack_target.hpp"
#include "dynamics/rotation/free_motion.hpp"
#include "dynamics/rotation/theta_motion.hpp"

namespace rigid_body_sim {
namespace {

/// A number of several bodies that lies at another place in each.
template <class Get>
RIGID_BODY_SIM_INLINE void gather(const FlightLane* lanes, const Get& get, double& to) {
  to = get(lanes[0]);
}

template <class Get, int kLanes, std::size_t... k>
RIGID_BODY_SIM_INLINE void gatherLanes(const FlightLane* lanes, const Get& get, Pack<kLanes>& to,
                                       std::index_sequence<k...>) {
  to.v = typename VectorOf<kLanes>::Type{get(lanes[k])...};
}

template <class Get, int kLanes>
RIGID_BODY_SIM_INLINE void gather(const FlightLane* lanes, const Get& get, Pack<kLanes>& to) {
  gatherLanes(lanes, get, to, std::make_index_sequence<kLanes>());
}

template <class T, class Get>
RIGID_BODY_SIM_INLINE T gathered(const FlightLane* lanes, const Get& get) {
  T value;
  gather(lanes, get, value);
  return value;
}

template <class T>
RIGID_BODY_SIM_INLINE Triple<T> gatheredTriple(const FlightLane* lanes,
                                               const double* FlightLane::*from) {
  const auto at = [from](int i) {
    return [from, i](const FlightLane& lane)
               RIGID_BODY_SIM_INLINE_LAMBDA { return (lane.*from)[i]; };
  };
  return {gathered<T>(lanes, at(0)), gathered<T>(lanes, at(1)), gathered<T>(lanes, at(2))};
}

template <class T>
RIGID_BODY_SIM_INLINE void put(const Triple<T>& v, int column, std::size_t lane,
                               FlightBlock& block) {
  store(v.x, block.columns[column] + lane);
  store(v.y, block.columns[column + 1] + lane);
  store(v.z, block.columns[column + 2] + lane);
}

/// As FreeFlight::at.
template <bool is_first, class T>
RIGID_BODY_SIM_INLINE void fly(const FlightLane* lanes, std::size_t lane, FlightBlock& block) {
  const T dt =
      gathered<T>(lanes, [](const FlightLane& l) RIGID_BODY_SIM_INLINE_LAMBDA { return l.dt; });
  const T mass =
      gathered<T>(lanes, [](const FlightLane& l) RIGID_BODY_SIM_INLINE_LAMBDA { return l.mass; });
  const Triple<T> f = gatheredTriple<T>(lanes, &FlightLane::f_W);
  const Triple<T> p = gatheredTriple<T>(lanes, &FlightLane::p_W);
  Triple<T> x = gatheredTriple<T>(lanes, &FlightLane::x_W);
  Triple<T> low = gatheredTriple<T>(lanes, &FlightLane::x_low_W);
  const Triple<T> way = T(dt / mass) * (p + T(0.5 * dt) * f);
  moveBy(way.x, x.x, low.x);
  moveBy(way.y, x.y, low.y);
  moveBy(way.z, x.z, low.z);
  put(x, kFlightPosition, lane, block);
  put(low, kFlightPositionLow, lane, block);
  put(p + dt * f, kFlightMomentum, lane, block);
  Quad<T> q_WP;
  Triple<T> L_P;
  const auto number = [lanes](int i) RIGID_BODY_SIM_INLINE_LAMBDA {
    return gathered<T>(
        lanes, [i](const FlightLane& l) RIGID_BODY_SIM_INLINE_LAMBDA { return l.rotation[i]; });
  };
  thetaMotion<is_first>(number, dt, q_WP, L_P);
  put(Triple<T>{q_WP.x, q_WP.y, q_WP.z}, kFlightAttitude, lane, block);
  store(q_WP.w, block.columns[kFlightAttitude + 3] + lane);
  put(L_P, kFlightSpin, lane, block);
}

template <bool is_first, class T>
RIGID_BODY_SIM_INLINE void flyAll(const FlightLane* lanes, std::size_t count, FlightBlock& block) {
  constexpr std::size_t kAtOnce = sizeof(T) / sizeof(double);
  for (std::size_t k = 0; k < count; k += kAtOnce) fly<is_first, T>(lanes + k, k, block);
}

template <bool is_first, class T>
void flyNarrow(const FlightLane* lanes, std::size_t count, FlightBlock& block) {
  flyAll<is_first, T>(lanes, count, block);
}

#if defined(__x86_64__)
template <bool is_first, class T>
RIGID_BODY_SIM_TARGET("avx2")
void flyWide(const FlightLane* lanes, std::size_t count, FlightBlock& block) {
  flyAll<is_first, T>(lanes, count, block);
}

template <bool is_first, class T>
RIGID_BODY_SIM_TARGET("avx512f")
void flyWidest(const FlightLane* lanes, std::size_t count, FlightBlock& block) {
  flyAll<is_first, T>(lanes, count, block);
}
#endif

std::vector<FlightKernels> flightKernelsOfThisProcessor() {
  std::vector<FlightKernels> kernels{{1, "", flyNarrow<true, double>, flyNarrow<false, double>},
                                     {2, "", flyNarrow<true, Pack<2>>, flyNarrow<false, Pack<2>>}};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2"))
    kernels.push_back({4, "AVX2", flyWide<true, Pack<4>>, flyWide<false, Pack<4>>});
  if (__builtin_cpu_supports("avx512f"))
    kernels.push_back({8, "AVX-512", flyWidest<true, Pack<8>>, flyWidest<false, Pack<8>>});
#endif
  return kernels;
}

void scatter(const FlightBlock& block, std::size_t lane, const BodyState& start, BodyState& state) {
  const auto copy = [&](int column, auto& to) {
    for (int i = 0; i < to.size(); ++i) to(i) = block.columns[column + i][lane];
  };
  copy(kFlightPosition, state.x_W);
  copy(kFlightPositionLow, state.x_low_W);
  copy(kFlightAttitude, state.q_WP.coeffs());
  copy(kFlightMomentum, state.p_W);
  copy(kFlightSpin, state.L_P);
  state.L_W = start.L_W;
}

}  // namespace

const std::vector<FlightKernels>& flightKernels() {
  static const std::vector<FlightKernels> kernels = flightKernelsOfThisProcessor();
  return kernels;
}

const FlightKernels& flightKernelsFor(std::size_t bodies) {
  for (const FlightKernels& each : flightKernels())
    if (each.lanes >= bodies) return each;
  return flightKernels().back();
}

void FlightBatch::read(const FreeFlight& flight, double dt, BodyState& state) {
  const ThetaRotation* rotation = flight.rotation().asTheta();
  if (!rotation) {
    state = flight.at(dt);
    return;
  }
  const BodyState& start = flight.start();
  Shelf& shelf = rotation->axis() == 0 ? first_ : last_;
  shelf.lanes[shelf.size] = {dt,
                             flight.mass(),
                             flight.force().data(),
                             start.x_W.data(),
                             start.x_low_W.data(),
                             start.p_W.data(),
                             rotation->numbers()};
  shelf.flights[shelf.size] = &flight;
  shelf.states[shelf.size] = &state;
  if (++shelf.size < FlightBlock::kLanes) return;
  evaluate(shelf, rotation->axis() == 0 ? &FlightKernels::first : &FlightKernels::last);
}

/// Lanes without a body repeat one.
void FlightBatch::evaluate(Shelf& shelf, FlightStep FlightKernels::*step) {
  if (shelf.size == 0) return;
  for (std::size_t k = shelf.size; k < FlightBlock::kLanes; ++k) shelf.lanes[k] = shelf.lanes[0];
  FlightBlock block;
  const FlightKernels& kernels = only_ ? *only_ : flightKernelsFor(shelf.size);
  (kernels.*step)(shelf.lanes.data(), shelf.size, block);
  for (std::size_t k = 0; k < shelf.size; ++k)
    scatter(block, k, shelf.flights[k]->start(), *shelf.states[k]);
  shelf.size = 0;
}

void FlightBatch::finish() {
  evaluate(first_, &FlightKernels::first);
  evaluate(last_, &FlightKernels::last);
}

}  // namespace rigid_body_sim
