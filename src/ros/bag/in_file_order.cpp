#include "ros/bag/in_file_order.hpp"

#include <algorithm>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include <rosbag/bag.h>
#include <rosbag/view.h>

namespace rigid_body_sim {
namespace {

class FileOrder : private rosbag::View {
 public:
  explicit FileOrder(const rosbag::Bag& bag) : View(bag), bag_(bag) {
    update();
    for (const rosbag::MessageRange* range : ranges_)
      for (auto entry = range->begin; entry != range->end; ++entry)
        entries_.emplace_back(*entry, range->connection_info);
    const auto place = [](const Entry& entry) {
      return std::tie(entry.first.chunk_pos, entry.first.offset);
    };
    std::sort(entries_.begin(), entries_.end(),
              [&place](const Entry& a, const Entry& b) { return place(a) < place(b); });
  }

  void read(const std::function<void(const rosbag::MessageInstance&)>& take) {
    for (const auto& [index, connection] : entries_)
      take(*std::unique_ptr<rosbag::MessageInstance>(newMessageInstance(connection, index, bag_)));
  }

 private:
  using Entry = std::pair<rosbag::IndexEntry, const rosbag::ConnectionInfo*>;

  const rosbag::Bag& bag_;
  std::vector<Entry> entries_;
};

}  // namespace

void inFileOrder(const rosbag::Bag& bag,
                 const std::function<void(const rosbag::MessageInstance&)>& take) {
  FileOrder(bag).read(take);
}

}  // namespace rigid_body_sim
