#include "scene/meshes/read_obj.hpp"

#include <utility>

#include "scene/files/word_reader.hpp"
#include "scene/meshes/mesh_room.hpp"
#include "scene/meshes/number_precision.hpp"

namespace rigid_body_sim {
namespace {

/// A backslash at the end of a line means that the line goes on.
void joinLines(std::string& text) {
  for (std::size_t at = text.find('\\'); at != std::string::npos; at = text.find('\\', at + 1)) {
    std::size_t end = at + 1;
    if (text.compare(end, 2, "\r\n") == 0) text[end++] = ' ';
    if (end < text.size() && (text[end] == '\n' || text[end] == '\r')) text[at] = text[end] = ' ';
  }
}

void blankComments(std::string& text) {
  bool comment = false;
  for (char& c : text) {
    comment = c != '\n' && c != '\r' && (comment || c == '#');
    if (comment) c = ' ';
  }
}

/// x y z, or x y z w, or with a colour x y z r g b.
Vector3d readVertex(WordReader& line, NumberPrecision& precision) {
  Vector3d v;
  for (int i = 0; i < 3; ++i) {
    const std::string_view word = line.wordOfLine();
    v[i] = line.number(word);
    precision.add(word, v[i]);
  }
  const std::string_view fourth = line.wordOfLine();
  const bool is_weight = !fourth.empty() && line.wordOfLine().empty();
  if (is_weight && line.number(fourth) != 1) line.fail("a vertex of weight 1", fourth);
  return v;
}

/// Index of the vertex that the word names: <vertex>, <vertex>/..; counted from 1, or backwards
/// from −1, the last so far.
std::uint32_t cornerOf(std::string_view word, std::size_t vertices, const WordReader& line) {
  std::size_t i = 0;
  const bool backwards = word[0] == '-';
  if (backwards) ++i;
  std::size_t count = 0;
  for (; i < word.size() && word[i] >= '0' && word[i] <= '9' && count <= vertices; ++i)
    count = 10 * count + static_cast<std::size_t>(word[i] - '0');
  const bool ends = i == word.size() || word[i] == '/';
  if (!ends || count == 0 || count > vertices)
    line.fail("one of the " + std::to_string(vertices) + " vertices before it", word);
  return static_cast<std::uint32_t>(backwards ? vertices - count : count - 1);
}

void readFace(WordReader& line, TriangleMesh& mesh) {
  Triangle fan{};
  int corners = 0;
  for (std::string_view word = line.wordOfLine(); !word.empty(); word = line.wordOfLine()) {
    fan[1] = fan[2];
    fan[2] = cornerOf(word, mesh.vertices.size(), line);
    if (corners == 0) fan[0] = fan[2];
    if (++corners < 3) continue;
    requireRoom(mesh);
    mesh.triangles.push_back(fan);
  }
  if (corners < 3) line.fail("a face of three corners or more", std::to_string(corners));
}

}  // namespace

FileMesh readObj(std::string text) {
  if (text.compare(0, 3, "\xEF\xBB\xBF") == 0) text.erase(0, 3);  // byte order mark
  blankComments(text);
  joinLines(text);
  TriangleMesh mesh;
  NumberPrecision precision;
  WordReader line(text);
  do {
    const std::string_view keyword = line.wordOfLine();
    if (keyword == "v")
      mesh.vertices.push_back(readVertex(line, precision));
    else if (keyword == "f")
      readFace(line, mesh);
  } while (line.nextLine());
  const Vector3d rounding = Vector3d::Constant(precision.rounding(mesh.vertices));
  return {std::move(mesh), rounding};
}

}  // namespace rigid_body_sim
