#pragma once

#include <deque>
#include <memory>
#include <mutex>

#include "core/contacts/world_pieces.h"
#include "core/lidar/lidar_scene.h"
#include "core/view/world_look.h"
#include "f1tenth_sim2d/world_model.h"

namespace f1tenth_sim2d
{
/// What is computed from a world once, for any number of simulations on any threads.
class WorldGeometry
{
public:
  explicit WorldGeometry(WorldDescription world) : world_(std::move(world)), pieces_(world_) {}
  WorldGeometry(const WorldGeometry &) = delete;
  WorldGeometry & operator=(const WorldGeometry &) = delete;

  const WorldDescription & world() const { return world_; }
  const WorldPieces & pieces() const { return pieces_; }
  /// What is seen at a height, m; cut at the first call.
  const WorldSection & sectionAt(double height) const;
  /// What cameras see; read at the first call.
  const WorldLook & look() const;

private:
  const WorldDescription world_;
  const WorldPieces pieces_;
  mutable std::mutex mutex_;  ///< guards what follows
  mutable std::deque<WorldSection> sections_;
  mutable std::unique_ptr<const WorldLook> look_;
};
}  // namespace f1tenth_sim2d
