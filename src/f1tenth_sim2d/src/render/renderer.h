#pragma once

#include "render/camera.h"
#include "render/scene.h"
#include "render/shadow_map.h"
#include "render/visibility.h"

namespace f1tenth_sim2d
{
/// Draws pictures; keeps its buffers from one to the next. The same input gives the same bits on every machine.
class Renderer
{
public:
  /// @param shadows_of_fixed  of the same scene
  /// @param pose              of the camera in the world: it looks along x, z is up
  void draw(
    const Scene & scene, const ShadowMap & shadows_of_fixed, const Pinhole & camera, const Transform & pose,
    Picture & picture);

private:
  Visibility visibility_;
  ShadowMap moving_shadows_;
};
}  // namespace f1tenth_sim2d
