#pragma once

#include <cstddef>
#include <vector>

#include "f1tenth_sim2d/world_model.h"
#include "render/shadow_map.h"

namespace f1tenth_sim2d
{
/// What cameras see of a world; reads the files of all its visuals.
class WorldLook
{
public:
  /// Something that moves with a model.
  struct Movable
  {
    std::size_t model;
    Surface surface;
    Transform pose;  ///< relative to the model's position and heading on the ground
  };

  explicit WorldLook(const WorldDescription & world);

  const Scene & fixed() const { return fixed_; }
  const ShadowMap & shadowsOfFixed() const { return shadows_; }
  const std::vector<Movable> & movables() const { return movables_; }

private:
  Scene fixed_;
  ShadowMap shadows_;
  std::vector<Movable> movables_;
};
}  // namespace f1tenth_sim2d
