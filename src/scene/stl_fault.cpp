#include "stl_fault.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>

namespace rigid_body_sim {
namespace {

// 80 bytes of text, the number of triangles (32 bits, little-endian), then 50 bytes a triangle
constexpr std::size_t kCountAt = 80;
constexpr std::size_t kHeader = 84;
constexpr std::uint64_t kTriangle = 50;

}  // namespace

std::string stlFault(const std::string& path) {
  std::array<char, kHeader> header{};
  std::ifstream file(path, std::ios::binary);
  file.read(header.data(), header.size());
  const std::string start(header.data(), static_cast<std::size_t>(file.gcount()));

  // Binary files too may begin with "solid", but text holds no zero byte; a count has one below
  // 2²⁴ triangles.
  const std::size_t text = start.find_first_not_of(" \t\r\n");
  const bool begins_with_solid = text != std::string::npos && start.compare(text, 5, "solid") == 0;
  if (begins_with_solid && start.find('\0') == std::string::npos) return {};

  const std::uint64_t size = std::filesystem::file_size(path);
  if (start.size() < kHeader)
    return "binary STL must have a header of 84 bytes, got " + std::to_string(size) + " bytes";
  std::uint64_t triangles = 0;
  for (std::size_t byte = 0; byte < 4; ++byte)
    triangles |= std::uint64_t(static_cast<unsigned char>(start[kCountAt + byte])) << 8 * byte;
  const std::uint64_t claimed = kHeader + kTriangle * triangles;
  if (size < claimed)
    return "binary STL is truncated: its header claims " + std::to_string(triangles) +
           " triangles, " + std::to_string(claimed) + " bytes, got " + std::to_string(size) +
           " bytes";
  return {};
}

}  // namespace rigid_body_sim
