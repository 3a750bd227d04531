#include "render/renderer.h"

#include <utility>
#include <vector>

#include "render/shading.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kAhead = 4.0;  // m, from the camera to the middle of the shadows that move
}  // namespace

void Renderer::draw(
  const Scene & scene, const ShadowMap & shadows_of_fixed, const Pinhole & camera, const Transform & pose,
  Picture & picture)
{
  visibility_.draw(scene, camera, pose);
  moving_shadows_.showMoving(scene, pose({kAhead, 0.0, 0.0}));
  std::vector<const ShadowMap *> shadows;
  for (const ShadowMap * const map : {&std::as_const(moving_shadows_), &shadows_of_fixed}) {
    if (!map->isEmpty()) {
      shadows.push_back(map);
    }
  }
  const std::size_t pixels = static_cast<std::size_t>(camera.width) * static_cast<std::size_t>(camera.height);
  picture.width = camera.width;
  picture.height = camera.height;
  picture.colours.resize(3 * pixels);
  picture.depths.resize(pixels);
  const Shading shading(visibility_, scene.light, shadows, camera, pose);
  for (int row = 0; row < camera.height; ++row) {
    shading.shadeRow(row, picture);
  }
}
}  // namespace f1tenth_sim2d
