#include "core/view/world_look.h"

#include "core/math/planar_pose.h"

namespace f1tenth_sim2d
{
WorldLook::WorldLook(const WorldDescription & world)
{
  for (std::size_t i = 0; i < world.models.size(); ++i) {
    const ModelDescription & model = world.models[i];
    const Transform frame = toTransform(model.is_static ? model.pose : withoutPlanar(model.pose));
    for (const Visual & visual : model.visuals) {
      const Transform pose = frame * toTransform(visual.pose);
      for (const Surface & surface : visual.look->appearance().surfaces) {
        if (model.is_static) {
          fixed_.surfaces.push_back({surface, pose});
        } else {
          movables_.push_back({i, surface, pose});
        }
      }
    }
  }
  shadows_.showFixed(fixed_);
}
}  // namespace f1tenth_sim2d
