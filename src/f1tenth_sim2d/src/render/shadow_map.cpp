#include "render/shadow_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace f1tenth_sim2d
{
namespace
{
constexpr float kDeepest = std::numeric_limits<float>::lowest();
constexpr double kLiftInTexels = 1.5;
constexpr int kFixedSide = 2048;       // pixels of the map of all that never moves, at most
constexpr double kFixedTexel = 0.004;  // m, at least
constexpr int kMovingSide = 512;       // pixels
constexpr double kMovingTexel = 0.02;  // m

/// Turns the world so that z points to the sun.
Transform acrossTheLight(const Vec3 & to_sun)
{
  const Vec3 level = std::abs(to_sun.z) > 0.9 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 0.0, 1.0};
  const Vec3 across = normalized(cross(level, to_sun));
  return {{across, cross(to_sun, across), to_sun}, {}};
}

std::vector<const PlacedSurface *> castersOf(const Scene & scene, bool moving)
{
  std::vector<const PlacedSurface *> casters;
  for (const PlacedSurface & placed : scene.surfaces) {
    if (placed.surface.casts_shadow && placed.moves == moving) {
      casters.push_back(&placed);
    }
  }
  return casters;
}

/// The ball around a surface.
Vec3 middleOf(const PlacedSurface & placed)
{
  return placed.pose(placed.surface.mesh->middle);
}
}  // namespace

void ShadowMap::showFixed(const Scene & scene)
{
  const std::vector<const PlacedSurface *> casters = castersOf(scene, false);
  const Transform turned = acrossTheLight(scene.light.to_sun);
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  double left = kInfinite;
  double right = -kInfinite;
  double top = kInfinite;
  double bottom = -kInfinite;
  for (const PlacedSurface * const caster : casters) {
    const double radius = caster->surface.mesh->radius;
    const Vec3 middle = turned(middleOf(*caster));
    left = std::min(left, middle.x - radius);
    right = std::max(right, middle.x + radius);
    top = std::min(top, middle.y - radius);
    bottom = std::max(bottom, middle.y + radius);
  }
  if (!(left <= right)) {
    is_empty_ = true;
    return;
  }
  const double texel = std::max(kFixedTexel, std::max(right - left, bottom - top) / (kFixedSide - 2));
  const auto count = [texel](double extent) { return static_cast<int>(extent / texel) + 2; };
  show(scene, casters, {left, top, texel, count(right - left), count(bottom - top)});
}

void ShadowMap::showMoving(const Scene & scene, const Vec3 & around)
{
  const Transform turned = acrossTheLight(scene.light.to_sun);
  const Vec3 middle = turned(around);
  // In whole texels, so that edges of shadows do not crawl while the camera moves.
  const auto start = [](double place) { return kMovingTexel * (std::floor(place / kMovingTexel) - kMovingSide / 2); };
  const Window window{start(middle.x), start(middle.y), kMovingTexel, kMovingSide, kMovingSide};
  std::vector<const PlacedSurface *> casters = castersOf(scene, true);
  const auto isOutside = [&](const PlacedSurface * caster) {
    const Vec3 at = turned(middleOf(*caster));
    const double radius = caster->surface.mesh->radius;
    constexpr double kExtent = kMovingTexel * kMovingSide;
    return at.x < window.left - radius || at.x > window.left + kExtent + radius || at.y < window.top - radius ||
           at.y > window.top + kExtent + radius;
  };
  casters.erase(std::remove_if(casters.begin(), casters.end(), isOutside), casters.end());
  show(scene, casters, window);
}

void ShadowMap::show(const Scene & scene, const std::vector<const PlacedSurface *> & casters, const Window & window)
{
  is_empty_ = casters.empty();
  lift_ = kLiftInTexels * window.texel;
  map_from_world_ = acrossTheLight(scene.light.to_sun);
  map_from_world_.rows[0] = (1.0 / window.texel) * map_from_world_.rows[0];
  map_from_world_.rows[1] = (1.0 / window.texel) * map_from_world_.rows[1];
  map_from_world_.offset = {-window.left / window.texel, -window.top / window.texel, 0.0};
  if (is_empty_) {
    return;
  }
  raster_.clear(window.columns, window.rows, kDeepest, std::numeric_limits<float>::infinity());
  std::vector<RasterCorner> corners;
  double left = window.columns;
  double right = -1.0;
  double top = window.rows;
  double bottom = -1.0;
  for (const PlacedSurface * const caster : casters) {
    const Transform map_from_surface = map_from_world_ * caster->pose;
    corners.clear();
    for (const Vec3 & corner : caster->surface.mesh->corners) {
      const Vec3 at = map_from_surface(corner);
      left = std::min(left, at.x);
      right = std::max(right, at.x);
      top = std::min(top, at.y);
      bottom = std::max(bottom, at.y);
      raster_.locate(corners.emplace_back(RasterCorner{at.x, at.y, 1.0, at.z}));
    }
    for (const auto & [a, b, c] : caster->surface.mesh->triangles) {
      raster_.draw(corners[a], corners[b], corners[c], true, 0);
    }
  }
  // Where light is interpolated, a pixel reaches as far as the next.
  const auto within = [](double place, int count) {
    return static_cast<float>(std::max(0.0, std::min(place, count - 1.0)));
  };
  first_column_ = within(left - 1.0, window.columns);
  last_column_ = within(right + 1.0, window.columns);
  first_row_ = within(top - 1.0, window.rows);
  last_row_ = within(bottom + 1.0, window.rows);
  findHighest();
}

void ShadowMap::findHighest()
{
  highest_.resize(static_cast<std::size_t>(raster_.width()) * static_cast<std::size_t>(raster_.height()));
  for (int row = static_cast<int>(first_row_); static_cast<float>(row) < last_row_; ++row) {
    const float * const upper = raster_.nearness(row);
    const float * const lower = raster_.nearness(row + 1);
    float * const found = &highest_[static_cast<std::size_t>(row) * static_cast<std::size_t>(raster_.width())];
    for (int i = static_cast<int>(first_column_); static_cast<float>(i) < last_column_; ++i) {
      found[i] = std::max(std::max(upper[i], upper[i + 1]), std::max(lower[i], lower[i + 1]));
    }
  }
}
}  // namespace f1tenth_sim2d
