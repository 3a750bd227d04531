#include "loaders/shapes/mesh_file.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include "f1tenth_sim2d/errors.h"
#include "loaders/files/farthest.h"
#include "loaders/shapes/known_files.h"

namespace f1tenth_sim2d
{
namespace
{
using Eigen::Vector3d;

bool hasName(const std::vector<std::string> & names, const std::string & name)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// The triangles of a selection.
class SurfaceBuilder
{
public:
  SurfaceBuilder(const MeshParts & mesh, const MeshSelection & selection) : scale_(selection.scale)
  {
    for (const MeshPart & part : mesh.parts) {
      if (selection.submesh.empty() || hasName(part.names, selection.submesh)) {
        add(part);
      }
    }
  }

  TriangleMesh surface;

private:
  void add(const MeshPart & part)
  {
    std::vector<std::uint32_t> index;
    for (const auto & [x, y, z] : part.corners) {
      index.push_back(indexOf(Vector3d(x, y, z).cwiseProduct(scale_)));
    }
    for (const auto & [a, b, c] : part.triangles) {
      addTriangle(index[a], index[b], index[c]);
    }
  }

  /// Corners are told apart by position only: neighbours with different normals or colours share a vertex.
  std::uint32_t indexOf(const Vector3d & vertex)
  {
    if (!vertex.allFinite() || vertex.cwiseAbs().maxCoeff() > kFarthest) {
      throw Error("has a vertex that is not finite or farther than 100 km from its origin");
    }
    const auto next = static_cast<std::uint32_t>(surface.vertices.size());
    const auto [known, is_new] = index_of_.try_emplace({vertex.x(), vertex.y(), vertex.z()}, next);
    if (is_new) {
      surface.vertices.push_back(vertex);
    }
    return known->second;
  }

  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c)
  {
    if (a != b && b != c && c != a) {
      surface.triangles.push_back(scale_.prod() < 0.0 ? std::array{a, c, b} : std::array{a, b, c});
    }
  }

  const Vector3d scale_;
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
}  // namespace

std::shared_ptr<const TriangleMesh> readMeshFile(const std::string & path, const MeshSelection & selection)
{
  const std::shared_ptr<const MeshParts> file = partsOfFile(path);
  const auto mesh = std::make_shared<TriangleMesh>(SurfaceBuilder(*file, selection).surface);
  if (mesh->triangles.empty()) {
    throw Error(
      selection.submesh.empty() || hasName(file->names, selection.submesh)
        ? "holds no triangles"
        : "has no submesh '" + selection.submesh + "', there are: " + listed({file->names.begin(), file->names.end()}));
  }
  if (selection.centred) {
    moveMiddleToOrigin(*mesh);
  }
  return mesh;
}
}  // namespace f1tenth_sim2d
