#include <algorithm>

#include "dynamics/packs/pack_steps.hpp"

// One source for every width: pack_steps.hpp is compiled for each instruction set by the attribute
// `target`, and chosen at run time. No multiplication and addition are contracted, so that all
// widths give the same bits.
namespace rigid_body_sim {
namespace {

/// Blocks that stay in the nearest cache while several steps are taken with them.
constexpr std::size_t kBlocksAtOnce = 8;

template <class Step, class T>
RIGID_BODY_SIM_INLINE void stepAll(const double* h, int count, PackBlock* blocks,
                                   std::size_t bodies) {
  constexpr std::size_t kLanes = sizeof(T) / sizeof(double);
  constexpr std::size_t kAtOnce = kBlocksAtOnce * PackBlock::kLanes;
  for (std::size_t first = 0; first < bodies; first += kAtOnce) {
    const std::size_t end = std::min(bodies, first + kAtOnce);
    for (int k = 0; k < count; ++k)
      for (std::size_t i = first; i < end; i += kLanes) {
        PackLanes<T> lanes(blocks[i / PackBlock::kLanes], i % PackBlock::kLanes);
        Step::step(h[k], lanes);
      }
  }
}

template <class Step, class T>
void narrow(const double* h, int count, PackBlock* blocks, std::size_t bodies) {
  stepAll<Step, T>(h, count, blocks, bodies);
}

#if defined(__x86_64__)
// clang 14 spills wide registers to a stack that it has not aligned for them, unless it is told to
#if defined(__clang__)
#define RIGID_BODY_SIM_TARGET(name) __attribute__((target(name), force_align_arg_pointer))
#else
#define RIGID_BODY_SIM_TARGET(name) __attribute__((target(name)))
#endif

template <class Step, class T>
RIGID_BODY_SIM_TARGET("avx2")
void wide(const double* h, int count, PackBlock* blocks, std::size_t bodies) {
  stepAll<Step, T>(h, count, blocks, bodies);
}

template <class Step, class T>
RIGID_BODY_SIM_TARGET("avx512f")
void widest(const double* h, int count, PackBlock* blocks, std::size_t bodies) {
  stepAll<Step, T>(h, count, blocks, bodies);
}
#endif

// In the order of PackKind.
#define RIGID_BODY_SIM_PACK_STEPS(step, T)                                                \
  {                                                                                       \
    step<SemiImplicitEulerPack, T>, step<StrangPack<0, 2>, T>, step<StrangPack<2, 0>, T>, \
        step<StrangPack<1, 2>, T>, step<Magnus4Pack, T>, step<Rk4Pack, T>                 \
  }

std::vector<PackKernels> kernelsOfThisProcessor() {
  std::vector<PackKernels> kernels{{1, "", RIGID_BODY_SIM_PACK_STEPS(narrow, double)},
                                   {2, "", RIGID_BODY_SIM_PACK_STEPS(narrow, Pack<2>)}};
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) {
    kernels.push_back({4, "AVX2", RIGID_BODY_SIM_PACK_STEPS(wide, Pack<4>)});
    kernels.push_back({8, "AVX2", RIGID_BODY_SIM_PACK_STEPS(wide, Twin<4>)});
  }
  if (__builtin_cpu_supports("avx512f"))
    kernels.push_back({8, "AVX-512", RIGID_BODY_SIM_PACK_STEPS(widest, Pack<8>)});
#endif
  return kernels;
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
