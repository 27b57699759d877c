#include <algorithm>
#include <utility>

#include "dynamics/packs/most_lanes.hpp"
#include "dynamics/packs/pack_steps.hpp"
#include "dynamics/packs/pack_target.hpp"
#include "math/sanitizers.hpp"

// One source for every width: pack_steps.hpp is compiled for each instruction set by the attribute
// `target`, and chosen at run time. No multiplication and addition are contracted, so that all
// widths give the same bits.
namespace rigid_body_sim {
namespace {

/// Blocks that stay in the nearest cache while several steps are taken with them.
constexpr std::size_t kBlocksAtOnce = 4;

template <class T>
RIGID_BODY_SIM_INLINE NoPush pushOf(const NoPush* /*none*/, const PushBlock* /*none*/,
                                    std::size_t /*lane*/) {
  return {};
}

template <class T, class Push>
RIGID_BODY_SIM_INLINE Push pushOf(const Push* /*none*/, const PushBlock* pushes, std::size_t lane) {
  return {pushes[lane / PackBlock::kLanes], lane % PackBlock::kLanes};
}

template <class Step, class T, class Push>
RIGID_BODY_SIM_INLINE void stepAll(const double* h, int count, PackBlock* blocks,
                                   const PushBlock* pushes, std::size_t bodies) {
  constexpr std::size_t kBytes = 8, kLanes = sizeof(T) / kBytes;  // of a double
  constexpr std::size_t kAtOnce = kBlocksAtOnce * PackBlock::kLanes;
  for (std::size_t first = 0; first < bodies; first += kAtOnce) {
    const std::size_t end = std::min(bodies, first + kAtOnce);
    for (int k = 0; k < count; ++k)
      for (std::size_t i = first; i < end; i += kLanes) {
        PackLanes<T> lanes(blocks[i / PackBlock::kLanes], i % PackBlock::kLanes);
        Step::step(h[k], lanes, pushOf<T>(static_cast<const Push*>(nullptr), pushes, i));
      }
  }
}

template <class Step, class T, class Push>
void narrow(const double* h, int count, PackBlock* blocks, const PushBlock* pushes,
            std::size_t bodies) {
  stepAll<Step, T, Push>(h, count, blocks, pushes, bodies);
}

#if defined(__x86_64__)
template <class Step, class T, class Push>
RIGID_BODY_SIM_TARGET("avx2")
void wide(const double* h, int count, PackBlock* blocks, const PushBlock* pushes,
          std::size_t bodies) {
  stepAll<Step, T, Push>(h, count, blocks, pushes, bodies);
}

template <class Step, class T, class Push>
RIGID_BODY_SIM_TARGET("avx512f")
void widest(const double* h, int count, PackBlock* blocks, const PushBlock* pushes,
            std::size_t bodies) {
  stepAll<Step, T, Push>(h, count, blocks, pushes, bodies);
}
#endif

// In the order of PackKind.
#define RIGID_BODY_SIM_STEPS_WITH(step, T, Push)                           \
  {                                                                        \
    step<SemiImplicitEulerPack, T, Push>, step<StrangPack<0, 2>, T, Push>, \
        step<StrangPack<2, 0>, T, Push>, step<StrangPack<1, 2>, T, Push>,  \
        step<Magnus4Pack, T, Push>, step<Rk4Pack, T, Push>                 \
  }
#define RIGID_BODY_SIM_PACK_STEPS(step, T)                                                        \
  {                                                                                               \
    RIGID_BODY_SIM_STEPS_WITH(step, T, NoPush), RIGID_BODY_SIM_STEPS_WITH(step, T, PushLanes<T>), \
        RIGID_BODY_SIM_STEPS_WITH(step, T, DragLanes<T>)                                          \
  }

// The widest kernels are of two registers: while one waits for a result, the other is computed;
// measured, a tenth to two fifths more. What threads share is the same at every width, which the
// thread sanitizer's build shall not wait for.
std::vector<PackKernels> kernelsOfThisProcessor() {
  std::vector<PackKernels> kernels{{1, "", RIGID_BODY_SIM_PACK_STEPS(narrow, double)},
                                   {2, "", RIGID_BODY_SIM_PACK_STEPS(narrow, Pack<2>)}};
#if defined(__x86_64__) && !defined(RIGID_BODY_SIM_THREAD_SANITIZER)
  if (__builtin_cpu_supports("avx2")) {
    kernels.push_back({4, "AVX2", RIGID_BODY_SIM_PACK_STEPS(wide, Pack<4>)});
    kernels.push_back({8, "AVX2", RIGID_BODY_SIM_PACK_STEPS(wide, Twin<4>)});
  }
#if !defined(RIGID_BODY_SIM_ADDRESS_SANITIZER)  // what it reads and writes is that of the narrower
  if (__builtin_cpu_supports("avx512f"))
    kernels.push_back({16, "AVX-512", RIGID_BODY_SIM_PACK_STEPS(widest, Twin<8>)});
#endif
#endif
  return upToMostLanes(std::move(kernels));
}

}  // namespace

const std::vector<PackKernels>& packKernels() {
  static const std::vector<PackKernels> kernels = kernelsOfThisProcessor();
  return kernels;
}

const PackKernels& packKernelsFor(std::size_t bodies) {
  const std::vector<PackKernels>& kernels = packKernels();
  for (const PackKernels& each : kernels)
    if (each.lanes >= bodies) return each;
  return kernels.back();
}

}  // namespace rigid_body_sim
