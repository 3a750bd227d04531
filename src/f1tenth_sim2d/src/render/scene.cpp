#include "render/scene.h"

#include <algorithm>

namespace f1tenth_sim2d
{
void enclose(SurfaceMesh & mesh)
{
  if (mesh.corners.empty()) {
    return;
  }
  Vec3 low = mesh.corners.front();
  Vec3 high = low;
  for (const Vec3 & corner : mesh.corners) {
    low = {std::min(low.x, corner.x), std::min(low.y, corner.y), std::min(low.z, corner.z)};
    high = {std::max(high.x, corner.x), std::max(high.y, corner.y), std::max(high.z, corner.z)};
  }
  mesh.middle = 0.5 * (low + high);
  mesh.radius = 0.0;
  for (const Vec3 & corner : mesh.corners) {
    mesh.radius = std::max(mesh.radius, norm(corner - mesh.middle));
  }
}
}  // namespace f1tenth_sim2d
