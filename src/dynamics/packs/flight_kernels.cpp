#include "dynamics/packs/flight_kernels.hpp"

#include <utility>

#include "dynamics/packs/most_lanes.hpp"
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

/// The numbers of flights, each gathered where it is.
template <class T>
class Scattered {
 public:
  RIGID_BODY_SIM_INLINE Scattered(const FlightLane* lanes, std::size_t lane)
      : lanes_(lanes + lane) {}

  RIGID_BODY_SIM_INLINE T dt() const {
    return gathered<T>(lanes_,
                       [](const FlightLane& l) RIGID_BODY_SIM_INLINE_LAMBDA { return l.dt; });
  }
  RIGID_BODY_SIM_INLINE T mass() const {
    return gathered<T>(lanes_,
                       [](const FlightLane& l) RIGID_BODY_SIM_INLINE_LAMBDA { return l.mass; });
  }
  RIGID_BODY_SIM_INLINE T force(int i) const { return at(&FlightLane::f_W, i); }
  RIGID_BODY_SIM_INLINE T start(int i) const { return at(&FlightLane::start, i); }
  RIGID_BODY_SIM_INLINE T rotation(int i) const { return at(&FlightLane::rotation, i); }

 private:
  RIGID_BODY_SIM_INLINE T at(const double* FlightLane::*from, int i) const {
    return gathered<T>(lanes_, [from, i](const FlightLane& l)
                                   RIGID_BODY_SIM_INLINE_LAMBDA { return (l.*from)[i]; });
  }

  const FlightLane* lanes_;
};

/// The same, made columns of before: for four bodies four numbers at a time.
template <class T>
class Transposed {
 public:
  RIGID_BODY_SIM_INLINE Transposed(const FlightLane* lanes, std::size_t lane) {
    for (std::size_t k = 0; k < kLanes; ++k) {
      const FlightLane& from = lanes[lane + k];
      columns_[kDt][k] = from.dt;
      columns_[kMass][k] = from.mass;
      for (int i = 0; i < 3; ++i) columns_[kForce + i][k] = from.f_W[i];
    }
    for (std::size_t k = 0; k < kLanes; k += 4) {
      const FlightLane* four = lanes + lane + k;
      // what overlaps is written twice
      for (const int i : {0, 4, 8, 12, 16, 20, 24, kThetaNumbers - 4})
        transpose(four, &FlightLane::rotation, i, kRotation, k);
      for (const int i : {0, 2, 10, 12}) transpose(four, &FlightLane::start, i, kStart, k);
    }
  }

  RIGID_BODY_SIM_INLINE T dt() const { return at(kDt); }
  RIGID_BODY_SIM_INLINE T mass() const { return at(kMass); }
  RIGID_BODY_SIM_INLINE T force(int i) const { return at(kForce + i); }
  RIGID_BODY_SIM_INLINE T start(int i) const { return at(kStart + i); }
  RIGID_BODY_SIM_INLINE T rotation(int i) const { return at(kRotation + i); }

 private:
  static constexpr std::size_t kLanes = sizeof(T) / sizeof(double);
  enum Column : int {
    kDt = 0,
    kMass = 1,
    kForce = 2,
    kStart = 5,
    kRotation = kStart + kSpinColumn,
    kColumns = kRotation + kThetaNumbers
  };

  RIGID_BODY_SIM_INLINE void transpose(const FlightLane* four, const double* FlightLane::*from,
                                       int i, int column, std::size_t lane) {
    const auto row = [&](int k) RIGID_BODY_SIM_INLINE_LAMBDA { return four[k].*from + i; };
    const auto to = [&](int k)
                        RIGID_BODY_SIM_INLINE_LAMBDA { return columns_[column + i + k] + lane; };
    transposeFour({row(0), row(1), row(2), row(3)}, {to(0), to(1), to(2), to(3)});
  }

  RIGID_BODY_SIM_INLINE T at(int column) const {
    T value;
    load(columns_[column], value);
    return value;
  }

  alignas(64) double columns_[kColumns][kLanes];
};

template <class T>
RIGID_BODY_SIM_INLINE void put(const Triple<T>& v, int column, std::size_t lane,
                               FlightBlock& block) {
  store(v.x, block.columns[column] + lane);
  store(v.y, block.columns[column + 1] + lane);
  store(v.z, block.columns[column + 2] + lane);
}

/// As FreeFlight::at.
template <bool is_first, class T, class Numbers>
RIGID_BODY_SIM_INLINE void fly(const Numbers& of, std::size_t lane, FlightBlock& block) {
  const auto startAt = [&of](int i) RIGID_BODY_SIM_INLINE_LAMBDA {
    return Triple<T>{of.start(i), of.start(i + 1), of.start(i + 2)};
  };
  const T dt = of.dt();
  const Triple<T> f{of.force(0), of.force(1), of.force(2)}, p = startAt(kMomentumColumn);
  Triple<T> x = startAt(kPositionColumn), low = startAt(kPositionLowColumn);
  const Triple<T> way = T(dt / of.mass()) * (p + T(0.5 * dt) * f);
  moveBy(way.x, x.x, low.x);
  moveBy(way.y, x.y, low.y);
  moveBy(way.z, x.z, low.z);
  put(x, kPositionColumn, lane, block);
  put(low, kPositionLowColumn, lane, block);
  put(p + dt * f, kMomentumColumn, lane, block);
  put(startAt(kWorldSpinColumn), kWorldSpinColumn, lane, block);
  Quad<T> q_WP;
  Triple<T> L_P;
  const auto number = [&of](int i) RIGID_BODY_SIM_INLINE_LAMBDA { return of.rotation(i); };
  thetaMotion<is_first>(number, dt, q_WP, L_P);
  put(Triple<T>{q_WP.x, q_WP.y, q_WP.z}, kAttitudeColumn, lane, block);
  store(q_WP.w, block.columns[kAttitudeColumn + 3] + lane);
  put(L_P, kSpinColumn, lane, block);
}

template <bool is_first, class T, class Numbers>
RIGID_BODY_SIM_INLINE void flyAll(const FlightLane* lanes, std::size_t count, FlightBlock& block) {
  // NOLINTNEXTLINE(bugprone-sizeof-expression): T is a number or as many as a register holds
  constexpr std::size_t kAtOnce = sizeof(T) / sizeof(double);
  for (std::size_t k = 0; k < count; k += kAtOnce) fly<is_first, T>(Numbers(lanes, k), k, block);
}

void copyNarrow(const FlightBlock& block, BodyState* const* states) {
  for (std::size_t lane = 0; lane < FlightBlock::kLanes; ++lane)
    copyState(block.columns, lane, *states[lane]);
}

template <bool is_first, class T>
void flyNarrow(const FlightLane* lanes, std::size_t count, FlightBlock& block) {
  flyAll<is_first, T, Scattered<T>>(lanes, count, block);
}

#if defined(__x86_64__)
template <bool is_first, class T>
RIGID_BODY_SIM_TARGET("avx2")
void flyWide(const FlightLane* lanes, std::size_t count, FlightBlock& block) {
  flyAll<is_first, T, Transposed<T>>(lanes, count, block);
}

template <bool is_first, class T>
RIGID_BODY_SIM_TARGET("avx512f")
void flyWidest(const FlightLane* lanes, std::size_t count, FlightBlock& block) {
  flyAll<is_first, T, Transposed<T>>(lanes, count, block);
}

RIGID_BODY_SIM_TARGET("avx2")
void copyWide(const FlightBlock& block, BodyState* const* states) {
  copyStates(block.columns, states);
}
#endif

std::vector<FlightKernels> flightKernelsOfThisProcessor() {
  std::vector<FlightKernels> kernels{
      {1, "", flyNarrow<true, double>, flyNarrow<false, double>, copyNarrow},
      {2, "", flyNarrow<true, Pack<2>>, flyNarrow<false, Pack<2>>, copyNarrow}};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2"))
    kernels.push_back({4, "AVX2", flyWide<true, Pack<4>>, flyWide<false, Pack<4>>, copyWide});
  if (__builtin_cpu_supports("avx512f"))
    kernels.push_back(
        {8, "AVX-512", flyWidest<true, Pack<8>>, flyWidest<false, Pack<8>>, copyWide});
#endif
  return upToMostLanes(std::move(kernels));
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
  shelf.lanes[shelf.size] = {dt, flight.mass(), flight.force().data(), stateNumbers(start),
                             rotation->numbers()};
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
  if (shelf.size == FlightBlock::kLanes)
    kernels.copy(block, shelf.states.data());
  else
    for (std::size_t k = 0; k < shelf.size; ++k) copyState(block.columns, k, *shelf.states[k]);
  shelf.size = 0;
}

void FlightBatch::finish() {
  evaluate(first_, &FlightKernels::first);
  evaluate(last_, &FlightKernels::last);
}

}  // namespace rigid_body_sim
