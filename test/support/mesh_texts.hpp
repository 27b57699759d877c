#pragma once

#include <cstdint>
#include <sstream>
#include <string>

#include <rigid_body_sim/mass/triangle_mesh.hpp>

namespace rigid_body_sim {

/// The contents of mesh files, in the formats that the package reads.

inline std::string asciiStl(const TriangleMesh& mesh) {
  std::ostringstream text;
  text << "solid test\n";
  for (const Triangle& t : mesh.triangles) {
    text << "facet normal 0 0 0\n outer loop\n";
    for (const std::uint32_t corner : t)
      text << "  vertex " << mesh.vertices[corner].transpose() << "\n";
    text << " endloop\nendfacet\n";
  }
  text << "endsolid test\n";
  return text.str();
}

/// Little-endian machines only, as are all that ROS 1 runs on.
inline std::string binaryStl(const TriangleMesh& mesh) {
  std::string bytes(80, '\0');
  const auto append = [&bytes](const auto& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  append(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) append(0.0f);  // normal
    for (const std::uint32_t corner : t)
      for (int i = 0; i < 3; ++i) append(static_cast<float>(mesh.vertices[corner][i]));
    append(std::uint16_t{0});
  }
  return bytes;
}

inline std::string obj(const TriangleMesh& mesh) {
  std::ostringstream text;
  for (const Vector3d& v : mesh.vertices) text << "v " << v.transpose() << "\n";
  for (const Triangle& t : mesh.triangles)
    text << "f " << t[0] + 1 << " " << t[1] + 1 << " " << t[2] + 1 << "\n";
  return text.str();
}

/// Box of 1 × 2 × 0.5 about (2, 0.5, −1), six quadrilaterals.
inline const char* const kBrickOfQuads =
    "v 1.5 -0.5 -1.25\nv 2.5 -0.5 -1.25\nv 1.5 1.5 -1.25\nv 2.5 1.5 -1.25\n"
    "v 1.5 -0.5 -0.75\nv 2.5 -0.5 -0.75\nv 1.5 1.5 -0.75\nv 2.5 1.5 -0.75\n"
    "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";

/// COLLADA in centimetres, y up by its own account, written half a metre low with a node that lifts
/// it again.
inline std::string dae(const TriangleMesh& mesh) {
  std::ostringstream numbers, indices;
  for (const Vector3d& v : mesh.vertices)
    numbers << (100 * (v - Vector3d(0, 0, 0.5))).transpose() << " ";
  for (const Triangle& t : mesh.triangles) indices << t[0] << " " << t[1] << " " << t[2] << " ";
  std::ostringstream text;
  text << R"(<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="centimeter" meter="0.01"/><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g" name="g"><mesh>
<source id="p"><float_array id="a" count=")"
       << 3 * mesh.vertices.size() << "\">" << numbers.str() << R"(</float_array>
<technique_common><accessor source="#a" count=")"
       << mesh.vertices.size() << R"(" stride="3"><param name="X" type="float"/>
<param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count=")"
       << mesh.triangles.size() << R"("><input semantic="VERTEX" source="#v" offset="0"/>
<p>)" << indices.str()
       << R"(</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s" name="s"><node id="n" name="n">
<translate>0 0 50</translate><instance_geometry url="#g"/></node></visual_scene>
</library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
)";
  return text.str();
}

}  // namespace rigid_body_sim
