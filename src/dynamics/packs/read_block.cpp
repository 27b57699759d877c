#include "dynamics/packs/read_block.hpp"

#include "dynamics/packs/pack_target.hpp"
#include "dynamics/packs/state_columns.hpp"

namespace rigid_body_sim {
namespace {

#if defined(__x86_64__)
RIGID_BODY_SIM_TARGET("avx2")
void readBlockWide(const PackBlock& block, BodyState* const* states) {
  copyStates(block.columns, states);
}
#endif

ReadBlock readBlockOfThisProcessor() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return readBlockWide;
#endif
  return readBlockNarrow;
}

}  // namespace

void readBlockNarrow(const PackBlock& block, BodyState* const* states) {
  for (std::size_t lane = 0; lane < PackBlock::kLanes; ++lane)
    copyState(block.columns, lane, *states[lane]);
}

ReadBlock readBlock() {
  static const ReadBlock read = readBlockOfThisProcessor();
  return read;
}

}  // namespace rigid_body_sim
