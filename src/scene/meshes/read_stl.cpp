#include "scene/meshes/read_stl.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "scene/files/word_reader.hpp"
#include "scene/meshes/number_precision.hpp"

namespace rigid_body_sim {
namespace {

// 80 bytes of text, the number of triangles (32 bits, little-endian), then 50 bytes a triangle:
// normal and three corners, each three floats, and two bytes more
constexpr std::size_t kCountAt = 80;
constexpr std::size_t kHeader = 84;
constexpr std::size_t kTriangle = 50;
constexpr std::size_t kVector = 12;

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// The bytes without a byte order mark, which some editors put before a text.
std::string_view withoutMark(std::string_view bytes) {
  const bool marked = bytes.substr(0, kByteOrderMark.size()) == kByteOrderMark;
  return marked ? bytes.substr(kByteOrderMark.size()) : bytes;
}

/// Keywords are written in either case.
bool isWord(std::string_view word, std::string_view lower_case) {
  const auto matches = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b; };
  return std::equal(word.begin(), word.end(), lower_case.begin(), lower_case.end(), matches);
}

/// Binary files too may begin with "solid", but text holds no zero byte; a count has one below 2²⁴
/// triangles.
bool isAscii(const std::string& bytes) {
  const std::string_view start = withoutMark(bytes).substr(0, kHeader);
  const std::size_t text = start.find_first_not_of(" \t\r\n");
  return text != std::string_view::npos && isWord(start.substr(text, 5), "solid") &&
         start.find('\0') == std::string_view::npos;
}

/// Little-endian bytes, on any machine.
std::uint32_t readUint32(const char* bytes) {
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i) value = value << 8 | static_cast<unsigned char>(bytes[i]);
  return value;
}

double readFloat(const char* bytes) {
  const std::uint32_t bits = readUint32(bytes);
  float value;
  std::memcpy(&value, &bits, sizeof value);
  return static_cast<double>(value);
}

void addTriangle(TriangleMesh& mesh) {
  const auto next = static_cast<std::uint32_t>(mesh.vertices.size());
  mesh.triangles.push_back({next - 3, next - 2, next - 1});
}

FileMesh readBinary(const std::string& bytes) {
  if (bytes.size() < kHeader)
    throw std::runtime_error("binary STL must have a header of 84 bytes, got " +
                             std::to_string(bytes.size()) + " bytes");
  const std::uint64_t triangles = readUint32(&bytes[kCountAt]);
  const std::uint64_t claimed = kHeader + kTriangle * triangles;
  if (bytes.size() < claimed)
    throw std::runtime_error("binary STL is truncated: its header claims " +
                             std::to_string(triangles) + " triangles, " + std::to_string(claimed) +
                             " bytes, got " + std::to_string(bytes.size()) + " bytes");
  TriangleMesh mesh;
  mesh.vertices.reserve(3 * triangles);
  mesh.triangles.reserve(triangles);
  for (std::uint64_t i = 0; i < triangles; ++i) {
    const char* corner = &bytes[kHeader + kTriangle * i];
    for (int k = 0; k < 3; ++k) {
      corner += kVector;
      mesh.vertices.emplace_back(readFloat(corner), readFloat(corner + 4), readFloat(corner + 8));
    }
    addTriangle(mesh);
  }
  const Vector3d rounding = Vector3d::Constant(NumberPrecision().rounding(mesh.vertices));
  return {std::move(mesh), rounding};
}

class AsciiReader {
 public:
  explicit AsciiReader(const std::string& text) : reader_(text) {}

  FileMesh read() {
    for (std::string_view word = reader_.word(); !word.empty(); word = reader_.word()) {
      if (isWord(word, "facet"))
        readFacet();
      else if (isWord(word, "solid") || isWord(word, "endsolid"))
        reader_.nextLine();  // a name of any words
      else
        reader_.fail("facet, solid or endsolid", word);
    }
    const Vector3d rounding = Vector3d::Constant(precision_.rounding(mesh_.vertices));
    return {std::move(mesh_), rounding};
  }

 private:
  /// What follows the word facet: normal x y z outer loop, three times vertex x y z, endloop
  /// endfacet.
  void readFacet() {
    expect("normal");
    for (int i = 0; i < 3; ++i) reader_.word();  // ignored, and often wrong
    expect("outer");
    expect("loop");
    for (int corner = 0; corner < 3; ++corner) {
      expect("vertex");
      const double x = number(), y = number(), z = number();
      mesh_.vertices.emplace_back(x, y, z);
    }
    addTriangle(mesh_);
    expect("endloop");
    expect("endfacet");
  }

  void expect(const char* lower_case) {
    const std::string_view word = reader_.word();
    if (!isWord(word, lower_case)) reader_.fail(lower_case, word);
  }
  double number() {
    const std::string_view word = reader_.word();
    const double value = reader_.number(word);
    precision_.add(word, value);
    return value;
  }

  WordReader reader_;
  NumberPrecision precision_;
  TriangleMesh mesh_;
};

}  // namespace

FileMesh readStl(const std::string& bytes) {
  if (!isAscii(bytes)) return readBinary(bytes);
  if (withoutMark(bytes).size() == bytes.size()) return AsciiReader(bytes).read();
  const std::string text(withoutMark(bytes));
  return AsciiReader(text).read();
}

}  // namespace rigid_body_sim
