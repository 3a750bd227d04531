#include "mesh_reader/scene_parts.h"

#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/mesh.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/DefaultIOSystem.h>
#include <algorithm>
#include <assimp/Importer.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include "mesh_reader/collada.h"

namespace f1tenth_sim2d
{
namespace
{
/// What Assimp calls a file that it reads from memory, without the format.
const std::string kNameOfMemory = "$$$___magic___$$$.";

/// Opens what a mesh file names beside it: an OBJ has its colours and textures in files of their own.
class FilesBeside : public Assimp::DefaultIOSystem
{
public:
  FilesBeside(const std::string & mesh, std::vector<std::string> & missing)
  : folder_(std::filesystem::path(mesh).parent_path()), missing_(missing)
  {
  }

  Assimp::IOStream * Open(const char * name, const char * mode) override
  {
    Assimp::IOStream * const file = DefaultIOSystem::Open((folder_ / name).c_str(), mode);
    if (!file) {
      missing_.emplace_back(name);
    }
    return file;
  }

private:
  std::filesystem::path folder_;
  std::vector<std::string> & missing_;
};

/// The geometries of a scene, put where its nodes put them.
class PartCollector
{
public:
  explicit PartCollector(const aiScene & scene) : scene_(scene) { addNode(*scene.mRootNode, aiMatrix4x4(), {}); }

  MeshParts mesh;

private:
  void addNode(const aiNode & node, const aiMatrix4x4 & parent, std::vector<std::string> around)
  {
    const aiMatrix4x4 transform = parent * node.mTransformation;
    around.emplace_back(node.mName.C_Str());
    mesh.names.push_back(around.back());
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      addPart(*scene_.mMeshes[node.mMeshes[i]], transform, around);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
      addNode(*node.mChildren[i], transform, around);
    }
  }

  void addPart(const aiMesh & geometry, const aiMatrix4x4 & transform, std::vector<std::string> names)
  {
    names.emplace_back(geometry.mName.C_Str());
    mesh.names.push_back(names.back());
    MeshPart & part = mesh.parts.emplace_back();
    part.names = std::move(names);
    for (unsigned i = 0; i < geometry.mNumVertices; ++i) {
      const aiVector3D corner = transform * geometry.mVertices[i];
      part.corners.push_back({corner.x, corner.y, corner.z});
    }
    addLook(geometry, transform, part);
    const bool is_mirrored = transform.Determinant() < 0.0F;
    for (unsigned i = 0; i < geometry.mNumFaces; ++i) {
      const aiFace & face = geometry.mFaces[i];
      unsigned * const end = face.mIndices + face.mNumIndices;
      if (std::any_of(face.mIndices, end, [&](unsigned index) { return index >= geometry.mNumVertices; })) {
        throw std::runtime_error("cannot be read: a triangle names a vertex that is not there");
      }
      if (face.mNumIndices == 3) {
        part.triangles.push_back(
          {face.mIndices[0], face.mIndices[is_mirrored ? 2 : 1], face.mIndices[is_mirrored ? 1 : 2]});
      }
    }
  }

  void addLook(const aiMesh & geometry, const aiMatrix4x4 & transform, MeshPart & part)
  {
    const aiMatrix3x3 normals_from = aiMatrix3x3(transform).Inverse().Transpose();
    for (unsigned i = 0; geometry.HasNormals() && i < geometry.mNumVertices; ++i) {
      const aiVector3D normal = normals_from * geometry.mNormals[i];
      part.normals.push_back({normal.x, normal.y, normal.z});
    }
    for (unsigned i = 0; geometry.HasTextureCoords(0) && i < geometry.mNumVertices; ++i) {
      part.texture_points.push_back({geometry.mTextureCoords[0][i].x, geometry.mTextureCoords[0][i].y});
    }
    if (geometry.mMaterialIndex >= scene_.mNumMaterials) {
      return;
    }
    const aiMaterial & material = *scene_.mMaterials[geometry.mMaterialIndex];
    aiString name;
    aiColor3D colour;
    // Assimp gives files without materials one of its own.
    const bool is_given =
      material.Get(AI_MATKEY_NAME, name) == aiReturn_SUCCESS && name != aiString(AI_DEFAULT_MATERIAL_NAME);
    if (is_given && material.Get(AI_MATKEY_COLOR_DIFFUSE, colour) == aiReturn_SUCCESS) {
      part.colour = {colour.r, colour.g, colour.b};
    }
    if (aiString texture; material.GetTexture(aiTextureType_DIFFUSE, 0, &texture) == aiReturn_SUCCESS) {
      part.textures.emplace_back(texture.C_Str());
    }
  }

  const aiScene & scene_;
};

std::string bytesOf(const std::string & path)
{
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  if (!file || bytes.empty()) {
    throw std::runtime_error(file ? "cannot be read: the file is empty" : "cannot be read: it cannot be opened");
  }
  // Without a texture, the FBX exporter writes a URI without a path, on which Assimp aborts. Textures are not read.
  boost::algorithm::replace_all(bytes, ">file://<", ">nothing<");
  return bytes;
}

const aiScene * read(Assimp::Importer & importer, const std::string & bytes, const std::string & format)
{
  return importer.ReadFileFromMemory(
    bytes.data(), bytes.size(), aiProcess_Triangulate | aiProcess_SortByPType, format.c_str());
}

/// @return null if it cannot be read: the importer says why
const aiScene * readScene(Assimp::Importer & importer, const std::string & bytes, const std::string & format)
{
  if (format != "dae" && format != "DAE") {
    return read(importer, bytes, format);
  }
  const aiScene * const scene = read(importer, tidiedCollada(bytes), format);
  return scene ? scene : read(importer, geometryOfCollada(bytes), format);
}
}  // namespace

MeshParts readParts(const std::string & path)
{
  Assimp::Importer importer;
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
  std::vector<std::string> missing;
  importer.SetIOHandler(new FilesBeside(path, missing));  // whose owner it is
  const std::string format = path.substr(path.find_last_of('.') + 1);
  const aiScene * const scene = readScene(importer, bytesOf(path), format);
  if (!scene || !scene->mRootNode) {
    std::string reason = importer.GetErrorString();
    boost::algorithm::replace_all(reason, kNameOfMemory + format, "the file");
    throw std::runtime_error("cannot be read: " + reason);
  }
  MeshParts mesh = PartCollector(*scene).mesh;
  mesh.missing = std::move(missing);
  return mesh;
}
}  // namespace f1tenth_sim2d
