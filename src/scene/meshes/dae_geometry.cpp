#include "scene/meshes/dae_geometry.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <map>

#include "mass/merged_vertices.hpp"
#include "scene/meshes/mesh_room.hpp"

namespace rigid_body_sim {
namespace {

using Corners = std::vector<std::uint32_t>;  // indices of vertices

/// Where X, Y and Z stand in each entry of a source.
std::array<std::size_t, 3> slotsOf(const DaeElement& accessor) {
  std::array<std::size_t, 3> named{};
  std::array<bool, 3> found{};
  std::size_t slot = 0;
  for (const auto* param = accessor.FirstChildElement("param"); param;
       param = param->NextSiblingElement("param"), ++slot) {
    const char* const name = param->Attribute("name");
    if (!name || std::strlen(name) != 1) continue;
    const auto axis = static_cast<std::size_t>(*name - 'X');
    if (axis < 3) {
      named[axis] = slot;
      found[axis] = true;
    }
  }
  const bool all = found[0] && found[1] && found[2];
  return all ? named : std::array<std::size_t, 3>{0, 1, 2};
}

class GeometryReader {
 public:
  explicit GeometryReader(const DaeDocument& document) : document_(document) {}

  DaeGeometry read(const DaeElement& mesh) {
    for (const auto* child = mesh.FirstChildElement(); child; child = child->NextSiblingElement())
      readPrimitives(*child);
    const double rounding = precision_.rounding(mesh_.vertices);
    return {withMergedVertices(mesh_), rounding};
  }

 private:
  /// Vertices first … first + count − 1.
  struct Positions {
    std::size_t first = 0, count = 0;
  };

  /// One of the lists of indices of a primitive: which vertex each corner has.
  struct Input {
    Positions positions;
    std::size_t offset = 0, stride = 1;
  };

  void readPrimitives(const DaeElement& primitives) {
    const auto is = [&](const char* name) { return isNamed(primitives, name); };
    if (is("triangles"))
      readRuns(primitives, [](std::size_t) { return std::size_t{3}; });
    else if (is("polylist"))
      readPolylist(primitives);
    else if (is("polygons") || is("trifans"))
      forEachList(primitives, [this](const Corners& corners) { addFan(corners); });
    else if (is("tristrips"))
      forEachList(primitives, [this](const Corners& corners) { addStrip(corners); });
  }

  void readPolylist(const DaeElement& polylist) {
    const std::vector<std::size_t> counts = indicesIn(requiredChild(polylist, "vcount"));
    readRuns(polylist, [&](std::size_t i) { return i < counts.size() ? counts[i] : 0; });
  }

  /// Polygons one after the other in one list; lengthOf says how many corners each has.
  template <class LengthOf>
  void readRuns(const DaeElement& primitives, const LengthOf& lengthOf) {
    forEachList(primitives, [&](const Corners& corners) {
      std::size_t at = 0;
      for (std::size_t i = 0; at < corners.size(); ++i) {
        const std::size_t length = lengthOf(i);
        if (length == 0 || length > corners.size() - at)
          failAt(primitives, "must have as many corners as its polygons, got " +
                                 std::to_string(corners.size()));
        const auto first = corners.begin() + static_cast<std::ptrdiff_t>(at);
        addFan(Corners(first, first + static_cast<std::ptrdiff_t>(length)));
        at += length;
      }
    });
  }

  template <class Visit>
  void forEachList(const DaeElement& primitives, const Visit& visit) {
    if (const DaeElement* hole = primitives.FirstChildElement("ph"))
      failAt(*hole, "polygons with holes are not supported: export the mesh as triangles");
    const DaeElement* list = primitives.FirstChildElement("p");
    if (!list) return;
    const Input input = inputOf(primitives);
    for (; list; list = list->NextSiblingElement("p")) visit(cornersOf(*list, input));
  }

  Corners cornersOf(const DaeElement& list, const Input& input) const {
    const std::vector<std::size_t> indices = indicesIn(list);
    if (indices.size() % input.stride != 0)
      failAt(list, "must have " + std::to_string(input.stride) + " indices a corner, got " +
                       std::to_string(indices.size()));
    Corners corners;
    corners.reserve(indices.size() / input.stride);
    for (std::size_t i = input.offset; i < indices.size(); i += input.stride) {
      if (indices[i] >= input.positions.count)
        failAt(list, "index must be below the number of vertices, " +
                         std::to_string(input.positions.count) + ", got " +
                         std::to_string(indices[i]));
      corners.push_back(static_cast<std::uint32_t>(input.positions.first + indices[i]));
    }
    return corners;
  }

  Input inputOf(const DaeElement& primitives) {
    constexpr std::size_t kMaxInputs = 1000;
    Input input;
    bool found = false;
    for (const auto* e = primitives.FirstChildElement("input"); e;
         e = e->NextSiblingElement("input")) {
      const std::size_t offset = indexAttribute(*e, "offset", 0);
      if (offset >= kMaxInputs) failAt(*e, "offset must be below 1000");
      input.stride = std::max(input.stride, offset + 1);
      if (!e->Attribute("semantic", "VERTEX")) continue;
      input.offset = offset;
      input.positions = positionsOf(document_.referred(*e, "source", "vertices"));
      found = true;
    }
    if (!found) failAt(primitives, "missing an input of semantic VERTEX");
    return input;
  }

  Positions positionsOf(const DaeElement& vertices) {
    for (const auto* e = vertices.FirstChildElement("input"); e;
         e = e->NextSiblingElement("input")) {
      if (!e->Attribute("semantic", "POSITION")) continue;
      const DaeElement& source = document_.referred(*e, "source", "source");
      const auto [known, is_new] = positions_.emplace(&source, Positions{});
      if (is_new) known->second = readPositions(source);
      return known->second;
    }
    failAt(vertices, "missing an input of semantic POSITION");
  }

  Positions readPositions(const DaeElement& source) {
    const DaeElement& accessor =
        requiredChild(requiredChild(source, "technique_common"), "accessor");
    const std::vector<double> numbers =
        numbersIn(document_.referred(accessor, "source", "float_array"), &precision_);
    const std::size_t count = indexAttribute(accessor, "count", 0);
    const std::size_t offset = indexAttribute(accessor, "offset", 0);
    const std::size_t stride = indexAttribute(accessor, "stride", 1);
    const std::array<std::size_t, 3> slots = slotsOf(accessor);
    const std::size_t used = *std::max_element(slots.begin(), slots.end()) + 1;
    if (stride < used || stride > numbers.size() || offset > numbers.size() ||
        count > (numbers.size() - offset) / stride)
      failAt(accessor, "must name three numbers of each entry, and no more than there are, " +
                           std::to_string(numbers.size()));
    const std::size_t first = mesh_.vertices.size();
    for (std::size_t i = 0; i < count; ++i) {
      const double* const entry = numbers.data() + offset + i * stride;
      mesh_.vertices.emplace_back(entry[slots[0]], entry[slots[1]], entry[slots[2]]);
    }
    return {first, count};
  }

  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    requireRoom(mesh_);
    mesh_.triangles.push_back({a, b, c});
  }

  void addFan(const Corners& corners) {
    for (std::size_t i = 2; i < corners.size(); ++i)
      addTriangle(corners[0], corners[i - 1], corners[i]);
  }

  /// Every second triangle of a strip runs the other way.
  void addStrip(const Corners& corners) {
    for (std::size_t i = 2; i < corners.size(); ++i)
      addTriangle(corners[i - 2 + i % 2], corners[i - 1 - i % 2], corners[i]);
  }

  const DaeDocument& document_;
  TriangleMesh mesh_;
  NumberPrecision precision_;
  std::map<const DaeElement*, Positions> positions_;
};

}  // namespace

DaeGeometry readDaeGeometry(const DaeDocument& document, const DaeElement& geometry) {
  const DaeElement* const mesh = geometry.FirstChildElement("mesh");
  return mesh ? GeometryReader(document).read(*mesh) : DaeGeometry();
}

}  // namespace rigid_body_sim
