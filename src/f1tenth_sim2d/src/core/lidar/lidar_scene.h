#pragma once

#include <deque>
#include <mutex>
#include <vector>

#include "core/lidar/scan_space.h"
#include "core/lidar/wall_grid.h"
#include "f1tenth_sim2d/section.h"
#include "f1tenth_sim2d/simulation_types.h"
#include "f1tenth_sim2d/world_model.h"

namespace f1tenth_sim2d
{
/// Where everything that moves is now.
class MovingPoses
{
public:
  virtual ~MovingPoses() = default;
  /// @param model  index in the world
  virtual Pose2 ofModel(std::size_t model) const = 0;
  virtual Pose2 ofCar(CarId car) const = 0;
};

/// Section of a rigid body in its own planar frame, with a circle about the origin that holds it.
class MovingSection
{
public:
  /// @param frame  of the solids, relative to the planar frame of the body
  MovingSection(const std::vector<Solid> & solids, const Pose3 & frame, double height);

  void draw(const Transform2 & body, RangeRaster & raster) const;

private:
  Section section_;
  double radius_;  ///< m
};

/// What is seen of a world at one height, worked out once, for any number of simulations on any threads.
class WorldSection
{
public:
  WorldSection(const WorldDescription & world, double height);

  double height() const { return height_; }
  const WallGrid & walls() const { return walls_; }
  /// Where lidars with these beams scan.
  ScanSpaces & spacesFor(const Beams & beams) const;
  void drawModels(const MovingPoses & poses, RangeRaster & raster) const;

private:
  struct Movable
  {
    std::size_t model;
    MovingSection section;
  };

  double height_;  ///< m
  WallGrid walls_;
  std::vector<Movable> movables_;
  mutable std::mutex mutex_;  ///< guards what follows
  mutable std::deque<ScanSpaces> spaces_;
};

/// Everything that a lidar at one height sees: the world and all cars.
class LidarScene
{
public:
  /// @param world  outlives this
  explicit LidarScene(const WorldSection & world) : world_(&world) {}

  double height() const { return world_->height(); }
  void addCar(CarId id, const std::vector<Solid> & solids);

  /// Working memory for scans with these beams.
  ScanSpaces::Loan spaceFor(const Beams & beams) const { return world_->spacesFor(beams).borrow(); }
  /// Draws what is seen from a sensor of a car, which does not see itself.
  /// @param sensor     in the world
  /// @param range_max  m
  void draw(CarId own, const Pose2 & sensor, double range_max, const MovingPoses & poses, ScanSpace & space) const;

private:
  struct SeenCar
  {
    CarId id;
    MovingSection section;
  };

  const WorldSection * world_;
  std::vector<SeenCar> cars_;
};
}  // namespace f1tenth_sim2d
