#include "loaders/shapes/mesh_file.h"

#include <assimp/config.h>
#include <assimp/mesh.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <array>
#include <assimp/Importer.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

#include "f1tenth_sim2d/errors.h"
#include "loaders/files/farthest.h"
#include "loaders/shapes/child_process.h"

namespace f1tenth_sim2d
{
namespace
{
using Eigen::Vector3d;

/// What Assimp calls a file that it reads from memory, without the format.
const std::string kNameOfMemory = "$$$___magic___$$$.";

/// The triangles of a scene, put where its nodes put them.
class SurfaceBuilder
{
public:
  SurfaceBuilder(const aiScene & scene, const MeshSelection & selection) : scene_(scene), selection_(selection)
  {
    addNode(*scene.mRootNode, aiMatrix4x4(), selection.submesh.empty());
  }

  const TriangleMesh & surface() const { return surface_; }
  const std::set<std::string> & names() const { return names_; }

private:
  bool isWanted(const aiString & name)
  {
    names_.insert(name.C_Str());
    return name.C_Str() == selection_.submesh;
  }

  void addNode(const aiNode & node, const aiMatrix4x4 & parent, bool wanted)
  {
    const aiMatrix4x4 transform = parent * node.mTransformation;
    const bool all_wanted = isWanted(node.mName) || wanted;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      const aiMesh & mesh = *scene_.mMeshes[node.mMeshes[i]];
      if (isWanted(mesh.mName) || all_wanted) {
        addMesh(mesh, transform);
      }
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      addNode(*node.mChildren[i], transform, wanted);
    }
  }

  void addMesh(const aiMesh & mesh, const aiMatrix4x4 & transform)
  {
    const Vector3d & scale = selection_.scale;
    const bool mirrored = (transform.Determinant() < 0.0F) != (scale.x() * scale.y() * scale.z() < 0.0);
    std::vector<std::uint32_t> index;
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D vertex = transform * mesh.mVertices[i];
      index.push_back(indexOf(Vector3d(vertex.x, vertex.y, vertex.z).cwiseProduct(scale)));
    }
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace & face = mesh.mFaces[i];
      if (face.mNumIndices == 3) {
        addTriangle(index[face.mIndices[0]], index[face.mIndices[1]], index[face.mIndices[2]], mirrored);
      }
    }
  }

  /// Corners are told apart by position only: neighbours with different normals or colours share a vertex.
  std::uint32_t indexOf(const Vector3d & vertex)
  {
    if (!vertex.allFinite() || vertex.cwiseAbs().maxCoeff() > kFarthest) {
      throw Error("has a vertex that is not finite or farther than 100 km from its origin");
    }
    const auto next = static_cast<std::uint32_t>(surface_.vertices.size());
    const auto [known, is_new] = index_of_.try_emplace({vertex.x(), vertex.y(), vertex.z()}, next);
    if (is_new) {
      surface_.vertices.push_back(vertex);
    }
    return known->second;
  }

  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool mirrored)
  {
    if (a != b && b != c && c != a) {
      surface_.triangles.push_back(mirrored ? std::array{a, c, b} : std::array{a, b, c});
    }
  }

  const aiScene & scene_;
  const MeshSelection & selection_;
  TriangleMesh surface_;
  std::set<std::string> names_;
  std::map<std::array<double, 3>, std::uint32_t> index_of_;
};

void moveMiddleToOrigin(TriangleMesh & mesh)
{
  Eigen::AlignedBox3d box;
  for (const Vector3d & vertex : mesh.vertices) {
    box.extend(vertex);
  }
  for (Vector3d & vertex : mesh.vertices) {
    vertex -= box.center();
  }
}

std::string listed(const std::set<std::string> & names)
{
  std::string text;
  for (const std::string & name : names) {
    text += name.empty() ? "" : (text.empty() ? "" : ", ") + name;
  }
  return text.empty() ? "none that has a name" : text;
}

std::string bytesOf(const std::string & path)
{
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file || bytes.empty()) {
    throw Error(file ? "cannot be read: the file is empty" : "cannot be read: it cannot be opened");
  }
  // Without a texture, the FBX exporter writes a URI without a path, on which Assimp aborts. Textures are not read.
  boost::algorithm::replace_all(bytes, ">file://<", ">nothing<");
  return bytes;
}

const aiScene & import(Assimp::Importer & importer, const std::string & path)
{
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
  const std::string bytes = bytesOf(path);
  const std::string format = path.substr(path.find_last_of('.') + 1);
  const aiScene * const scene = importer.ReadFileFromMemory(
    bytes.data(), bytes.size(), aiProcess_Triangulate | aiProcess_SortByPType, format.c_str());
  if (!scene || !scene->mRootNode) {
    std::string reason = importer.GetErrorString();
    boost::algorithm::replace_all(reason, kNameOfMemory + format, "the file");
    throw Error("cannot be read: " + reason);
  }
  return *scene;
}

TriangleMesh meshOf(const std::string & path, const MeshSelection & selection)
{
  Assimp::Importer importer;
  const SurfaceBuilder builder(import(importer, path), selection);
  if (builder.surface().triangles.empty()) {
    throw Error(
      selection.submesh.empty() || builder.names().count(selection.submesh) > 0
        ? "holds no triangles"
        : "has no submesh '" + selection.submesh + "', there are: " + listed(builder.names()));
  }
  TriangleMesh mesh = builder.surface();
  if (selection.centred) {
    moveMiddleToOrigin(mesh);
  }
  return mesh;
}

template <typename T>
void pack(const std::vector<T> & values, std::string & bytes)
{
  const std::uint64_t count = values.size();
  bytes.append(reinterpret_cast<const char *>(&count), sizeof(count));
  bytes.append(reinterpret_cast<const char *>(values.data()), count * sizeof(T));
}

/// @return the bytes that follow
template <typename T>
const char * unpack(const char * bytes, std::vector<T> & values)
{
  std::uint64_t count = 0;
  std::memcpy(&count, bytes, sizeof(count));
  values.resize(count);
  std::memcpy(static_cast<void *>(values.data()), bytes + sizeof(count), count * sizeof(T));
  return bytes + sizeof(count) + count * sizeof(T);
}
}  // namespace

std::shared_ptr<const TriangleMesh> readMeshFile(const std::string & path, const MeshSelection & selection)
{
  const std::string bytes = resultOfChild([&] {
    const TriangleMesh mesh = meshOf(path, selection);
    std::string packed;
    pack(mesh.vertices, packed);
    pack(mesh.triangles, packed);
    return packed;
  });
  const auto mesh = std::make_shared<TriangleMesh>();
  unpack(unpack(bytes.data(), mesh->vertices), mesh->triangles);
  return mesh;
}
}  // namespace f1tenth_sim2d
