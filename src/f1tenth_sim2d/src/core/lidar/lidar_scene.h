#pragma once

#include <vector>

#include "core/lidar/wall_grid.h"
#include "f1tenth_sim2d/car_model.h"
#include "f1tenth_sim2d/section.h"
#include "f1tenth_sim2d/world_model.h"

namespace f1tenth_sim2d
{
/// Section of a rigid body in its own planar frame, with a circle about the origin that holds it.
class MovingSection
{
public:
  /// @param frame  of the solids, relative to the planar frame of the body
  MovingSection(const std::vector<Solid> & solids, const ignition::math::Pose3d & frame, double height);

  void draw(const Transform2 & body, RangeRaster & raster) const;

private:
  Section section_;
  double radius_{0.0};  ///< m
};

/// Where everything that moves is now; parallel to the models and cars given to the scene.
struct MovingPoses
{
  std::vector<Transform2> models;
  std::vector<Transform2> cars;
};

/// Everything that a lidar at one height sees.
class LidarScene
{
public:
  LidarScene(const WorldDescription & world, double height);

  double height() const { return height_; }
  void addCar(const CarDescription & car);

  /// Draws the world as it is seen from a car, which does not see itself.
  /// @param poses  movable models in the order of the world, and cars
  void draw(std::size_t own_car, const MovingPoses & poses, RangeRaster & raster);

private:
  double height_;  ///< m
  WallGrid walls_;
  std::vector<MovingSection> models_;
  std::vector<MovingSection> cars_;
};
}  // namespace f1tenth_sim2d
