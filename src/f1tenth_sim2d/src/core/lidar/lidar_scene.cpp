#include "core/lidar/lidar_scene.h"

#include <algorithm>
#include <cmath>

#include "core/math/planar_pose.h"

namespace f1tenth_sim2d
{
namespace
{
void append(Section & section, const std::vector<Solid> & solids, const ignition::math::Pose3d & frame, double height)
{
  for (const Solid & solid : solids) {
    const Section cut = sectionAt(solid, frame * solid.pose, height);
    section.outlines.insert(section.outlines.end(), cut.outlines.begin(), cut.outlines.end());
    section.circles.insert(section.circles.end(), cut.circles.begin(), cut.circles.end());
  }
}

Section staticSection(const WorldDescription & world, double height)
{
  Section section;
  for (const ModelDescription & model : world.models) {
    if (model.is_static) {
      append(section, model.solids, model.pose, height);
    }
  }
  return section;
}

double boundingRadius(const Section & section)
{
  double radius = 0.0;
  for (const Outline & outline : section.outlines) {
    for (const Vec2 & p : outline) {
      radius = std::max(radius, std::hypot(p.x, p.y));
    }
  }
  for (const Circle & circle : section.circles) {
    radius = std::max(radius, std::hypot(circle.centre.x, circle.centre.y) + circle.radius);
  }
  return radius;
}
}  // namespace

MovingSection::MovingSection(const std::vector<Solid> & solids, const ignition::math::Pose3d & frame, double height)
{
  append(section_, solids, frame, height);
  radius_ = boundingRadius(section_);
}

void MovingSection::draw(const Transform2 & body, RangeRaster & raster) const
{
  if (!raster.couldShow({body.x, body.y}, radius_)) {
    return;
  }
  for (const Outline & outline : section_.outlines) {
    Vec2 previous = body.apply(outline.back());
    for (const Vec2 & corner : outline) {
      const Vec2 next = body.apply(corner);
      raster.addSegment(previous, next);
      previous = next;
    }
  }
  for (const Circle & circle : section_.circles) {
    raster.addCircle(body.apply(circle.centre), circle.radius);
  }
}

LidarScene::LidarScene(const WorldDescription & world, double height)
: height_(height), walls_(staticSection(world, height))
{
  for (const ModelDescription & model : world.models) {
    if (!model.is_static) {
      models_.emplace_back(model.solids, withoutPlanar(model.pose), height);
    }
  }
}

void LidarScene::addCar(const CarDescription & car)
{
  cars_.emplace_back(car.solids, ignition::math::Pose3d::Zero, height_);
}

void LidarScene::draw(std::size_t own_car, const MovingPoses & poses, RangeRaster & raster)
{
  walls_.draw(raster);
  for (std::size_t i = 0; i < models_.size(); ++i) {
    models_[i].draw(poses.models[i], raster);
  }
  for (std::size_t i = 0; i < cars_.size(); ++i) {
    if (i != own_car) {
      cars_[i].draw(poses.cars[i], raster);
    }
  }
}
}  // namespace f1tenth_sim2d
