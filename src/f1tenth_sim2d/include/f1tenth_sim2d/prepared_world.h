#pragma once

#include <memory>

#include "f1tenth_sim2d/world_model.h"

namespace f1tenth_sim2d
{
class WorldGeometry;

/// A world that is ready to be simulated: its solids cut into the pieces that cars touch and the walls that lidars see.
/// No simulation changes it, so that any number of them, on any threads, can share one. A copy is the same world.
class PreparedWorld
{
public:
  /// @throws Error for what a simulation cannot be built from
  explicit PreparedWorld(WorldDescription world);

  const WorldDescription & description() const;

private:
  friend class Simulation;
  std::shared_ptr<const WorldGeometry> geometry_;
};
}  // namespace f1tenth_sim2d
