#include "tools/sweep/table_lines.hpp"

#include <algorithm>
#include <fstream>
#include <utility>

namespace rigid_body_sim {

TableLines::TableLines(std::string path, std::size_t piece)
    : path_(std::move(path)), piece_(piece) {}

bool TableLines::next(std::string& line, std::size_t most) {
  std::size_t searched = begin_, end = 0;
  while ((end = text_.find('\n', searched)) == std::string::npos && text_.size() - begin_ <= most) {
    searched = text_.size() - begin_;
    if (!readOn()) return false;
  }
  const bool is_whole = end != std::string::npos && end - begin_ <= most;
  const std::size_t length = is_whole ? end - begin_ : most + 1,
                    after = length + (is_whole ? 1 : 0);
  line.assign(text_, begin_, length);
  begin_ += after;
  bytes_ += static_cast<std::int64_t>(after);
  return true;
}

/// What is left of the text is then at its begin.
bool TableLines::readOn() {
  std::ifstream in(path_, std::ios::binary);
  in.seekg(offset_);
  text_.erase(0, begin_);
  begin_ = 0;
  const std::size_t kept = text_.size();
  text_.resize(kept + piece_);
  in.read(text_.data() + kept, static_cast<std::streamsize>(piece_));
  text_.resize(kept + static_cast<std::size_t>(in.gcount()));
  offset_ += in.gcount();
  return in.gcount() > 0;
}

std::size_t longestRow(const std::string& header) {
  // digits of a number, for each name and the comma after it; words, and why there is no result
  constexpr std::size_t kNumber = 32, kWords = 8 << 20;
  return kNumber * static_cast<std::size_t>(1 + std::count(header.begin(), header.end(), ',')) +
         kWords;
}

}  // namespace rigid_body_sim
