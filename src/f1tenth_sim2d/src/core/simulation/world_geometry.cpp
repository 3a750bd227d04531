#include "core/simulation/world_geometry.h"

#include <algorithm>

#include "core/simulation/validation.h"
#include "f1tenth_sim2d/simulation.h"

namespace f1tenth_sim2d
{
const WorldSection & WorldGeometry::sectionAt(double height) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = std::find_if(
    sections_.begin(), sections_.end(), [&](const WorldSection & section) { return section.height() == height; });
  return found != sections_.end() ? *found : sections_.emplace_back(world_, height);
}

const WorldLook & WorldGeometry::look() const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!look_) {
    look_ = std::make_unique<const WorldLook>(world_);
  }
  return *look_;
}

PreparedWorld::PreparedWorld(WorldDescription world)
{
  validate(world);
  geometry_ = std::make_shared<WorldGeometry>(std::move(world));
}

const WorldDescription & PreparedWorld::description() const
{
  return geometry_->world();
}
}  // namespace f1tenth_sim2d
