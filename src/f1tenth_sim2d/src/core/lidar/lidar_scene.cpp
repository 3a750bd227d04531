#include "core/lidar/lidar_scene.h"

#include <algorithm>

#include "core/math/planar_pose.h"

namespace f1tenth_sim2d
{
namespace
{
double boundingRadius(const Section & section)
{
  double radius = 0.0;
  for (const Outline & outline : section.outlines) {
    for (const Vec2 & p : outline) {
      radius = std::max(radius, norm(p));
    }
  }
  for (const Circle & circle : section.circles) {
    radius = std::max(radius, norm(circle.centre) + circle.radius);
  }
  return radius;
}
}  // namespace

MovingSection::MovingSection(const std::vector<Solid> & solids, const Pose3 & frame, double height)
: section_(sectionAt(solids, frame, height)), radius_(boundingRadius(section_))
{
}

void MovingSection::draw(const Transform2 & body, RangeRaster & raster) const
{
  if (!raster.couldShow({body.x, body.y}, radius_)) {
    return;
  }
  SeenWalls::Values a_x;
  SeenWalls::Values a_y;
  SeenWalls::Values b_x;
  SeenWalls::Values b_y;
  std::size_t count = 0;
  const auto drawThem = [&] {
    raster.addWalls({a_x.data(), a_y.data(), b_x.data(), b_y.data()}, count, [](std::size_t) { return true; });
    count = 0;
  };
  for (const Outline & outline : section_.outlines) {
    Vec2 previous = body.apply(outline.back());
    for (const Vec2 & corner : outline) {
      const Vec2 next = body.apply(corner);
      a_x[count] = previous.x;
      a_y[count] = previous.y;
      b_x[count] = next.x;
      b_y[count] = next.y;
      previous = next;
      if (++count == SeenWalls::kMost) {
        drawThem();
      }
    }
  }
  drawThem();
  for (const Circle & circle : section_.circles) {
    raster.addCircle(body.apply(circle.centre), circle.radius);
  }
}

WorldSection::WorldSection(const WorldDescription & world, double height)
: height_(height), walls_(staticSectionAt(world, height))
{
  for (std::size_t i = 0; i < world.models.size(); ++i) {
    const ModelDescription & model = world.models[i];
    if (!model.is_static) {
      movables_.push_back({i, MovingSection(model.solids, withoutPlanar(model.pose), height)});
    }
  }
}

ScanSpaces & WorldSection::spacesFor(const Beams & beams) const
{
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found =
    std::find_if(spaces_.begin(), spaces_.end(), [&](const ScanSpaces & spaces) { return spaces.beams() == beams; });
  return found != spaces_.end() ? *found : spaces_.emplace_back(beams, walls_.itemCount());
}

void WorldSection::drawModels(const MovingPoses & poses, RangeRaster & raster) const
{
  for (const Movable & movable : movables_) {
    movable.section.draw(Transform2(poses.ofModel(movable.model)), raster);
  }
}

void LidarScene::addCar(CarId id, const std::vector<Solid> & solids)
{
  cars_.push_back({id, MovingSection(solids, Pose3(), height())});
}

void LidarScene::draw(
  CarId own, const Pose2 & sensor, double range_max, const MovingPoses & poses, ScanSpace & space) const
{
  space.raster.begin(sensor, range_max);
  world_->walls().draw(space.raster, space.drawn);
  world_->drawModels(poses, space.raster);
  for (const SeenCar & car : cars_) {
    if (car.id != own) {
      car.section.draw(Transform2(poses.ofCar(car.id)), space.raster);
    }
  }
}
}  // namespace f1tenth_sim2d
