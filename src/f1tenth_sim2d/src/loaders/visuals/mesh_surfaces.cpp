#include "loaders/visuals/mesh_surfaces.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <mutex>

#include "f1tenth_sim2d/errors.h"
#include "loaders/files/farthest.h"
#include "loaders/files/files.h"
#include "loaders/shapes/known_files.h"
#include "loaders/visuals/texture_file.h"

namespace f1tenth_sim2d
{
namespace
{
namespace fs = std::filesystem;

bool isNear(const Vec3 & corner)
{
  return std::abs(corner.x) <= kFarthest && std::abs(corner.y) <= kFarthest && std::abs(corner.z) <= kFarthest;
}

std::shared_ptr<SurfaceMesh> toSurface(const MeshPart & part, const Eigen::Vector3d & scale)
{
  auto mesh = std::make_shared<SurfaceMesh>();
  for (const auto & [x, y, z] : part.corners) {
    mesh->corners.push_back({scale.x() * x, scale.y() * y, scale.z() * z});
  }
  for (const auto & [x, y, z] : part.normals) {
    mesh->normals.push_back(normalized({x / scale.x(), y / scale.y(), z / scale.z()}));
  }
  mesh->texture_points = part.texture_points;
  const bool is_mirrored = scale.prod() < 0.0;
  for (const auto & [a, b, c] : part.triangles) {
    if (isNear(mesh->corners[a]) && isNear(mesh->corners[b]) && isNear(mesh->corners[c])) {
      mesh->triangles.push_back({a, is_mirrored ? c : b, is_mirrored ? b : c});
    }
  }
  if (mesh->normals.empty()) {
    makeFlat(*mesh);
  }
  enclose(*mesh);
  return mesh;
}

/// As Gazebo looks for it: beside the mesh, or in the folders of materials of its model.
std::string findTexture(const std::string & mesh, const std::string & texture)
{
  const fs::path folder = fs::path(mesh).parent_path();
  const fs::path name = fs::path(texture).filename();
  for (const fs::path & path :
       {folder / texture, folder / name, folder.parent_path() / "materials" / "textures" / name}) {
    if (isFile(path.string())) {
      return path.string();
    }
  }
  throw Error("the texture " + texture + " of " + mesh + " is not found");
}

Material materialOf(const std::string & mesh, const MeshPart & part, std::string & warning)
{
  Material material;
  if (part.colour.size() == 3) {
    material.diffuse = {part.colour[0], part.colour[1], part.colour[2]};
  }
  if (!part.textures.empty() && !part.texture_points.empty()) {
    try {
      material.texture = readTexture(findTexture(mesh, part.textures.front()));
      material.diffuse = {1.0F, 1.0F, 1.0F};
    } catch (const Error & error) {
      warning = std::string(error.what()) + ": drawn in a plain colour";
    }
  }
  return material;
}

void moveMiddleToOrigin(const std::vector<std::shared_ptr<SurfaceMesh>> & meshes)
{
  Eigen::AlignedBox3d box;
  for (const auto & mesh : meshes) {
    for (const Vec3 & corner : mesh->corners) {
      box.extend(Eigen::Vector3d(corner.x, corner.y, corner.z));
    }
  }
  const Vec3 middle = toVec3(box.center());
  for (const auto & mesh : meshes) {
    for (Vec3 & corner : mesh->corners) {
      corner = corner - middle;
    }
    mesh->middle = mesh->middle - middle;
  }
}
}  // namespace

std::vector<Surface> surfacesOfMesh(
  const std::string & path, const MeshSelection & selection, const std::optional<Material> & given,
  std::string & warning)
{
  std::vector<Surface> surfaces;
  std::vector<std::shared_ptr<SurfaceMesh>> meshes;
  const std::shared_ptr<const MeshParts> mesh = partsOfFile(path);
  if (!given && !mesh->missing.empty()) {
    warning = mesh->missing.front() + ", which " + path + " names, is not found: drawn in a plain colour";
  }
  for (const MeshPart & part : mesh->parts) {
    const bool is_wanted = selection.submesh.empty() ||
                           std::find(part.names.begin(), part.names.end(), selection.submesh) != part.names.end();
    if (is_wanted && !part.triangles.empty()) {
      meshes.push_back(toSurface(part, selection.scale));
      surfaces.push_back({meshes.back(), given ? *given : materialOf(path, part, warning)});
    }
  }
  if (surfaces.empty()) {
    throw Error(path + " holds no triangles" + (selection.submesh.empty() ? "" : " of a submesh " + selection.submesh));
  }
  if (selection.centred) {
    moveMiddleToOrigin(meshes);
  }
  return surfaces;
}
}  // namespace f1tenth_sim2d
