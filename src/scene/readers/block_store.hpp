#pragma once

#include <algorithm>
#include <cstddef>
#include <list>
#include <vector>

namespace rigid_body_sim {

/// Values that stay where they are until the store ends. T: trivially copyable, so that a block of
/// them is given back as one.
template <class T>
class BlockStore {
 public:
  /// Room for that many values, one after the other, each T().
  T* make(std::size_t count) {
    if (blocks_.empty() || blocks_.back().capacity() - blocks_.back().size() < count) {
      blocks_.emplace_back();
      blocks_.back().reserve(std::max(kBlock, count));
    }
    std::vector<T>& block = blocks_.back();
    block.resize(block.size() + count);
    return block.data() + (block.size() - count);
  }

 private:
  static constexpr std::size_t kBlock = (1 << 17) / sizeof(T);  ///< 128 KiB: malloc maps these

  std::list<std::vector<T>> blocks_;
};

}  // namespace rigid_body_sim
