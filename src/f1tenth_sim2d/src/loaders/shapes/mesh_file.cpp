#include "loaders/shapes/mesh_file.h"

#include <algorithm>
#include <array>
#include <limits>
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

constexpr std::uint32_t kNoVertex = std::numeric_limits<std::uint32_t>::max();

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
  std::size_t left_out{0};

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
      return kNoVertex;
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
    if (std::max({a, b, c}) == kNoVertex) {
      ++left_out;
    } else if (a != b && b != c && c != a) {
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

MeshSurface readMeshFile(const std::string & path, const MeshSelection & selection)
{
  const std::shared_ptr<const MeshParts> file = partsOfFile(path);
  SurfaceBuilder builder(*file, selection);
  const auto mesh = std::make_shared<TriangleMesh>(std::move(builder.surface));
  if (mesh->triangles.empty()) {
    throw Error(
      selection.submesh.empty() || hasName(file->names, selection.submesh)
        ? std::string("holds no triangles") + (builder.left_out > 0 ? " within 100 km of its origin" : "")
        : "has no submesh '" + selection.submesh + "', there are: " + listed({file->names.begin(), file->names.end()}));
  }
  if (selection.centred) {
    moveMiddleToOrigin(*mesh);
  }
  return {mesh, builder.left_out};
}
}  // namespace f1tenth_sim2d
