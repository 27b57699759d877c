#include <algorithm>
#include <cctype>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <rigid_body_sim/scene/read_mesh.hpp>

#include "stl_fault.hpp"

namespace rigid_body_sim {
namespace {

[[noreturn]] void fail(const std::string& path, std::string reason) {
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  throw std::runtime_error(path + ": " + reason);
}

std::string extensionOf(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

/// What can be told before the reader opens the file.
void checkFile(const std::string& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) fail(path, "mesh file does not exist");
  if (!std::filesystem::is_regular_file(status)) fail(path, "mesh file must be a regular file");
  const std::string extension = extensionOf(path);
  if (extension != ".stl" && extension != ".obj" && extension != ".dae")
    fail(path, "mesh file must end in .stl, .obj or .dae, got '" + extension + "'");
  const std::string fault = extension == ".stl" ? stlFault(path) : "";
  if (!fault.empty()) fail(path, fault);
}

Eigen::Affine3d toAffine(const aiMatrix4x4& m) {
  Eigen::Affine3d X = Eigen::Affine3d::Identity();
  X.linear() << m.a1, m.a2, m.a3, m.b1, m.b2, m.b3, m.c1, m.c2, m.c3;
  X.translation() << m.a4, m.b4, m.c4;
  return X;
}

/// A vertex as the file has it; one that is not finite is told before a transform spreads it.
Vector3d finite(const aiVector3D& v, const std::string& path) {
  Vector3d vertex(v.x, v.y, v.z);
  if (vertex.allFinite()) return vertex;
  std::ostringstream reason;
  reason << "mesh vertices must be finite, got [" << vertex.transpose() << "]";
  fail(path, reason.str());
}

/// Appends the triangles of a mesh of the file at path, placed by X; where X mirrors, each is
/// turned round, for it would come out facing inwards.
void append(const aiMesh& part, const Eigen::Affine3d& X, const std::string& path,
            TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const bool mirrored = X.linear().determinant() < 0;
  for (unsigned i = 0; i < part.mNumVertices; ++i)
    mesh.vertices.push_back(X * finite(part.mVertices[i], path));
  for (unsigned i = 0; i < part.mNumFaces; ++i) {
    const aiFace& face = part.mFaces[i];
    if (face.mNumIndices != 3) continue;
    Triangle t{first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]};
    if (mirrored) std::swap(t[1], t[2]);
    mesh.triangles.push_back(t);
  }
}

/// Appends the meshes of a node and all nodes below it, each placed by its own transform.
void append(const aiScene& scene, const aiNode& node, const Eigen::Affine3d& X_parent,
            const std::string& path, TriangleMesh& mesh) {
  const Eigen::Affine3d X = X_parent * toAffine(node.mTransformation);
  for (unsigned i = 0; i < node.mNumMeshes; ++i)
    append(*scene.mMeshes[node.mMeshes[i]], X, path, mesh);
  for (unsigned i = 0; i < node.mNumChildren; ++i) append(scene, *node.mChildren[i], X, path, mesh);
}

}  // namespace

TriangleMesh readMesh(const std::string& path, double scale) {
  checkFile(path);
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene = importer.ReadFile(path, aiProcess_Triangulate);
  if (!scene || !scene->mRootNode)
    fail(path, std::string("mesh file cannot be read: ") + importer.GetErrorString());

  TriangleMesh mesh;
  append(*scene, *scene->mRootNode, Eigen::Affine3d(Eigen::Scaling(scale)), path, mesh);
  if (mesh.triangles.empty()) fail(path, "mesh must have at least one triangle, got 0");
  return mesh;
}

}  // namespace rigid_body_sim
