#include "render/shading.h"

#include <algorithm>
#include <limits>

namespace f1tenth_sim2d
{
namespace
{
/// Pixels for which one version of a texture is used.
constexpr int kPixelsPerLevel = 16;
/// Part of the surroundings' light that comes from above only, so that faces in the shade differ.
constexpr float kFromAbove = 0.25F;

/// A quantity that is linear over the image once it is divided by the depth, along a row.
struct RowValue
{
  float start;
  float step;

  RowValue(const PixelPlane & plane, int column, int row)
  : start(static_cast<float>(plane.at(column, row))), step(static_cast<float>(plane.x))
  {
  }
  float at(int column, float depth) const { return (start + step * static_cast<float>(column)) * depth; }
};

std::uint8_t toByte(float share)
{
  return static_cast<std::uint8_t>(std::min(255.0F, std::max(0.0F, share * 255.0F + 0.5F)));
}

void write(const Colour & colour, std::uint8_t * bytes)
{
  bytes[0] = toByte(colour.red);
  bytes[1] = toByte(colour.green);
  bytes[2] = toByte(colour.blue);
}

Colour operator*(const Colour & a, const Colour & b)
{
  return {a.red * b.red, a.green * b.green, a.blue * b.blue};
}
Colour operator*(float factor, const Colour & a)
{
  return {factor * a.red, factor * a.green, factor * a.blue};
}
Colour operator+(const Colour & a, const Colour & b)
{
  return {a.red + b.red, a.green + b.green, a.blue + b.blue};
}

/// The light that falls on a triangle: how it faces the sun and the sky, from corner to corner.
struct Lighting
{
  PixelPlane to_sun;
  PixelPlane upwards;
  Vec3 normal;  ///< of the triangle, unit, in the world

  Lighting(const Visibility::Triangle & triangle, const TriangleSetup & setup, const Vec3 & sun)
  {
    const PlacedSurface & placed = *triangle.placed;
    const SurfaceMesh & mesh = *placed.surface.mesh;
    const double side = setup.isFront() ? 1.0 : -1.0;
    std::array<Vec3, 3> normals;
    for (std::size_t i = 0; i < 3; ++i) {
      normals[i] = side * placed.pose.turned(mesh.normals[triangle.corners[i]]);
    }
    to_sun = setup.interpolated(dot(normals[0], sun), dot(normals[1], sun), dot(normals[2], sun));
    upwards = setup.interpolated(normals[0].z, normals[1].z, normals[2].z);
    const auto corner = [&](std::size_t i) { return mesh.corners[triangle.corners[i]]; };
    normal = side * placed.pose.turned(normalized(cross(corner(1) - corner(0), corner(2) - corner(0))));
  }
};

/// The texture of a triangle along a row; none if its surface has none.
class TextureRow
{
public:
  TextureRow(const Visibility::Triangle & triangle, const TriangleSetup & setup, int column, int row)
  : texture_(textureOf(triangle)),
    points_(pointsOf(triangle)),
    u_plane_(setup.interpolated(points_[0][0], points_[1][0], points_[2][0])),
    v_plane_(setup.interpolated(points_[0][1], points_[1][1], points_[2][1])),
    nearness_(setup.interpolated(1.0, 1.0, 1.0)),
    u_(u_plane_, column, row),
    v_(v_plane_, column, row)
  {
  }

  explicit operator bool() const { return texture_ != nullptr; }

  /// Chooses the version for the pixels around one.
  /// @param column  from the start of the row
  void chooseLevel(int column, float depth)
  {
    const float u = u_.at(column, depth);
    const float v = v_.at(column, depth);
    const auto change = [&](double PixelPlane::*part) {
      const auto of_nearness = static_cast<float>(nearness_.*part);
      return std::array<float, 2>{
        (static_cast<float>(u_plane_.*part) - u * of_nearness) * depth,
        (static_cast<float>(v_plane_.*part) - v * of_nearness) * depth};
    };
    level_ = texture_->levelFor(change(&PixelPlane::x), change(&PixelPlane::y));
  }

  Colour at(int column, float depth) const { return texture_->at(u_.at(column, depth), v_.at(column, depth), level_); }

private:
  static const Texture * textureOf(const Visibility::Triangle & triangle)
  {
    const Surface & surface = triangle.placed->surface;
    return surface.mesh->texture_points.empty() ? nullptr : surface.material.texture.get();
  }
  static std::array<std::array<float, 2>, 3> pointsOf(const Visibility::Triangle & triangle)
  {
    std::array<std::array<float, 2>, 3> points{};
    if (textureOf(triangle)) {
      for (std::size_t i = 0; i < 3; ++i) {
        points[i] = triangle.placed->surface.mesh->texture_points[triangle.corners[i]];
      }
    }
    return points;
  }

  const Texture * const texture_;
  const std::array<std::array<float, 2>, 3> points_;
  const PixelPlane u_plane_;
  const PixelPlane v_plane_;
  const PixelPlane nearness_;
  const RowValue u_;
  const RowValue v_;
  std::size_t level_{0};
};

/// The way of a triangle's pixels through a shadow map.
class ShadowRow
{
public:
  /// @param origin  the camera, in the map, lifted along the triangle's normal
  ShadowRow(const ShadowMap & map, const Vec3 & origin, const Vec3 & start, const Vec3 & step)
  : map_(map),
    origin_{static_cast<float>(origin.x), static_cast<float>(origin.y), static_cast<float>(origin.z)},
    start_{static_cast<float>(start.x), static_cast<float>(start.y), static_cast<float>(start.z)},
    step_{static_cast<float>(step.x), static_cast<float>(step.y), static_cast<float>(step.z)}
  {
  }

  float light(int column, float depth) const
  {
    const auto at = [&](std::size_t i) {
      return origin_[i] + (start_[i] + step_[i] * static_cast<float>(column)) * depth;
    };
    return map_.light(at(0), at(1), at(2));
  }

private:
  const ShadowMap & map_;
  std::array<float, 3> origin_;
  std::array<float, 3> start_;
  std::array<float, 3> step_;
};
}  // namespace

Shading::Shading(
  const Visibility & seen, const Light & light, const std::vector<const ShadowMap *> & shadows, const Pinhole & camera,
  const Transform & pose)
: seen_(seen), light_(light), shadows_(shadows), camera_(camera), pose_(pose)
{
}

std::vector<Shading::MapRay> Shading::mapRays(int row) const
{
  const Vec3 start = pose_.turned(camera_.ray(0.0, row));
  const Vec3 step = pose_.turned({0.0, -1.0 / camera_.focal_x, 0.0});
  std::vector<MapRay> rays;
  for (const ShadowMap * const map : shadows_) {
    rays.push_back({map, map->mapFromWorld().turned(start), map->mapFromWorld().turned(step)});
  }
  return rays;
}

void Shading::shadeRow(int row, Picture & picture) const
{
  const Raster & raster = seen_.raster();
  const std::size_t start = static_cast<std::size_t>(row) * static_cast<std::size_t>(camera_.width);
  const float * const nearness = raster.nearness(row);
  const std::uint32_t * const triangles = raster.triangles(row);
  float * const depths = &picture.depths[start];
  std::uint8_t * const colours = &picture.colours[3 * start];
  const std::vector<MapRay> rays = mapRays(row);
  for (int first = 0; first < camera_.width;) {
    const std::uint32_t triangle = triangles[first];
    int end = first;
    for (; end < camera_.width && triangles[end] == triangle; ++end) {
      depths[end] = triangle == Raster::kNothing ? std::numeric_limits<float>::infinity() : 1.0F / nearness[end];
    }
    const Run run{first, end, row};
    if (triangle == Raster::kNothing) {
      shadeSky(run, colours);
    } else {
      shadeRun(run, triangle, rays, colours, depths);
    }
    first = end;
  }
}

void Shading::shadeSky(const Run & run, std::uint8_t * colours) const
{
  for (int column = run.first; column < run.end; ++column) {
    const Vec3 direction = pose_.turned(camera_.ray(column, run.row));
    const double climb = std::max(0.0, direction.z / norm(direction));
    const auto share = static_cast<float>(climb * (2.0 - climb));
    write((1.0F - share) * light_.horizon + share * light_.zenith, colours + 3 * column);
  }
}

void Shading::shadeRun(
  const Run & run, std::uint32_t triangle, const std::vector<MapRay> & rays, std::uint8_t * colours,
  const float * depths) const
{
  const Visibility::Triangle & shown = seen_.triangle(triangle);
  const Material & material = shown.placed->surface.material;
  const TriangleSetup setup = seen_.setupOf(shown);
  const Lighting lighting(shown, setup, light_.to_sun);
  const RowValue to_sun(lighting.to_sun, run.first, run.row);
  const RowValue upwards(lighting.upwards, run.first, run.row);
  TextureRow texture(shown, setup, run.first, run.row);
  std::vector<ShadowRow> shadows;
  for (const MapRay & ray : rays) {
    const Vec3 origin = ray.map->mapFromWorld()(pose_.offset + ray.map->lift() * lighting.normal);
    shadows.emplace_back(*ray.map, origin, ray.start + static_cast<double>(run.first) * ray.step, ray.step);
  }
  for (int column = run.first; column < run.end; ++column) {
    const int i = column - run.first;
    const float depth = depths[column];
    const float above = (1.0F - kFromAbove) + kFromAbove * upwards.at(i, depth);
    Colour light = above * light_.surroundings;
    float sun = to_sun.at(i, depth);
    for (std::size_t k = 0; k < shadows.size() && sun > 0.0F; ++k) {
      sun *= shadows[k].light(i, depth);
    }
    if (sun > 0.0F) {
      light = light + sun * light_.sun;
    }
    Colour colour = light * material.diffuse;
    if (texture) {
      if (i == 0 || column % kPixelsPerLevel == 0) {
        texture.chooseLevel(i, depth);
      }
      colour = colour * texture.at(i, depth);
    }
    write(colour + material.emission, colours + 3 * column);
  }
}
}  // namespace f1tenth_sim2d
