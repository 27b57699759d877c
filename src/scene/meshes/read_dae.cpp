#include "scene/meshes/read_dae.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <assimp/Importer.hpp>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include "scene/files/xml_fault.hpp"
#include "scene/meshes/mesh_room.hpp"
#include "scene/message_text.hpp"

namespace rigid_body_sim {
namespace {

Eigen::Affine3d toAffine(const aiMatrix4x4& m) {
  Eigen::Affine3d X = Eigen::Affine3d::Identity();
  X.linear() << m.a1, m.a2, m.a3, m.b1, m.b2, m.b3, m.c1, m.c2, m.c3;
  X.translation() << m.a4, m.b4, m.c4;
  return X;
}

/// Appends the triangles of a mesh, placed by X; where X mirrors, each is turned round, for it
/// would come out facing inwards.
void append(const aiMesh& part, const Eigen::Affine3d& X, TriangleMesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  const bool mirrored = X.linear().determinant() < 0;
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    const aiVector3D& v = part.mVertices[i];
    mesh.vertices.push_back(X * Vector3d(v.x, v.y, v.z));
  }
  for (unsigned i = 0; i < part.mNumFaces; ++i) {
    const aiFace& face = part.mFaces[i];
    if (face.mNumIndices != 3) continue;
    requireRoom(mesh);
    Triangle t{first + face.mIndices[0], first + face.mIndices[1], first + face.mIndices[2]};
    if (mirrored) std::swap(t[1], t[2]);
    mesh.triangles.push_back(t);
  }
}

/// Appends the meshes of a node and all nodes below it, each placed by its own transform.
void append(const aiScene& scene, const aiNode& node, const Eigen::Affine3d& X_parent,
            TriangleMesh& mesh) {
  const Eigen::Affine3d X = X_parent * toAffine(node.mTransformation);
  for (unsigned i = 0; i < node.mNumMeshes; ++i) append(*scene.mMeshes[node.mMeshes[i]], X, mesh);
  for (unsigned i = 0; i < node.mNumChildren; ++i) append(scene, *node.mChildren[i], X, mesh);
}

}  // namespace

TriangleMesh readDae(const std::string& xml) {
  std::string fault = xmlFault(xml);
  // assimp follows it for ever where a node instances itself, and doubles with every level
  if (xml.find("<instance_node") != std::string::npos)
    fault = "instance_node is not taken: export the mesh with its instances expanded";
  if (!fault.empty()) throw std::runtime_error("mesh file cannot be read: " + fault);
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene =
      importer.ReadFileFromMemory(xml.data(), xml.size(), aiProcess_Triangulate, "dae");
  if (!scene || !scene->mRootNode)
    throw std::runtime_error("mesh file cannot be read: " + oneLine(importer.GetErrorString()));
  TriangleMesh mesh;
  append(*scene, *scene->mRootNode, Eigen::Affine3d::Identity(), mesh);
  return mesh;
}

}  // namespace rigid_body_sim
