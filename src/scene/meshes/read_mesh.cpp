#include "scene/meshes/read_mesh.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>
#include <utility>

#include "math/shortest.hpp"
#include "scene/files/read_file.hpp"
#include "scene/limits.hpp"
#include "scene/meshes/read_dae.hpp"
#include "scene/meshes/read_obj.hpp"
#include "scene/meshes/read_stl.hpp"

namespace rigid_body_sim {
namespace {

/// What can be told before the file is opened.
std::string fileFault(const std::string& path, const std::string& extension) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) return "mesh file does not exist" + lookedForIn(path);
  if (!std::filesystem::is_regular_file(status)) return "mesh file must be a regular file";
  if (extension != ".stl" && extension != ".obj" && extension != ".dae")
    return "mesh file must end in .stl, .obj or .dae, got '" + extension + "'";
  return "";
}

FileMesh meshIn(std::string bytes, const std::string& extension) {
  if (extension == ".stl") return readStl(bytes);
  if (extension == ".obj") return readObj(std::move(bytes));
  return readDae(bytes);
}

std::string meshFault(const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) return "mesh must have at least one triangle, got 0";
  const auto bad = std::find_if(mesh.vertices.begin(), mesh.vertices.end(),
                                [](const Vector3d& v) { return !v.allFinite(); });
  if (bad == mesh.vertices.end()) return "";
  return "mesh vertices must be finite, got " + shortest(*bad);
}

void applyScale(const Vector3d& scale, FileMesh& read) {
  for (Vector3d& v : read.mesh.vertices) v = v.cwiseProduct(scale);
  read.rounding = read.rounding.cwiseProduct(scale.cwiseAbs());
  if (scale.array().sign().prod() > 0) return;
  for (Triangle& t : read.mesh.triangles) std::swap(t[1], t[2]);
}

}  // namespace

std::string extensionOf(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

FileMesh readMesh(const std::string& path, const Vector3d& scale) {
  const std::string extension = extensionOf(path);
  std::string fault = fileFault(path, extension);
  FileMesh read;
  if (fault.empty()) {
    std::string bytes =
        readFile(path, "mesh file", extension == ".dae" ? kMaxDaeBytes : kMaxMeshBytes);
    try {
      read = meshIn(std::move(bytes), extension);
      fault = meshFault(read.mesh);
    } catch (const std::runtime_error& e) {
      fault = e.what();
    }
  }
  if (!fault.empty()) throw std::runtime_error(path + ": " + fault);
  applyScale(scale, read);
  return read;
}

}  // namespace rigid_body_sim
