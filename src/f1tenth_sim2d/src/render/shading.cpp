#include "render/shading.h"

#include <algorithm>
#include <limits>

namespace f1tenth_sim2d
{
namespace
{
/// Pixels side by side that are worked out together, for which one version of a texture is used.
constexpr int kBlock = 16;
/// Part of the surroundings' light that comes from above only, so that faces in the shade differ.
constexpr float kFromAbove = 0.25F;

/// One number for each pixel of a block.
using Block = std::array<float, kBlock>;

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
  /// @param first  of the block, from the start
  void fill(int first, const Block & depths, Block & values) const
  {
    for (int i = 0; i < kBlock; ++i) {
      values[i] = (start + step * static_cast<float>(first + i)) * depths[i];
    }
  }
};

/// The colours of a block.
struct Colours
{
  Block red;
  Block green;
  Block blue;

  void write(int count, std::uint8_t * bytes) const
  {
    std::array<std::int32_t, 3 * kBlock> rounded;
    const auto toByte = [](float share) {
      return static_cast<std::int32_t>(std::min(255.0F, std::max(0.0F, share * 255.0F + 0.5F)));
    };
    for (int i = 0; i < kBlock; ++i) {
      rounded[i] = toByte(red[i]);
      rounded[kBlock + i] = toByte(green[i]);
      rounded[2 * kBlock + i] = toByte(blue[i]);
    }
    for (int i = 0; i < count; ++i) {
      bytes[3 * i] = static_cast<std::uint8_t>(rounded[i]);
      bytes[3 * i + 1] = static_cast<std::uint8_t>(rounded[kBlock + i]);
      bytes[3 * i + 2] = static_cast<std::uint8_t>(rounded[2 * kBlock + i]);
    }
  }
};

/// @param sun    how the pixels of a block face the sun
/// @param above  how they face the sky
Colours litBy(const Light & light, const Colour & diffuse, const Block & sun, const Block & above)
{
  Colours lit;
  const auto add = [&](Block & channel, float Colour::*part) {
    const float surroundings = light.surroundings.*part * (diffuse.*part);
    const float of_sun = light.sun.*part * (diffuse.*part);
    for (int i = 0; i < kBlock; ++i) {
      channel[i] = ((1.0F - kFromAbove) + kFromAbove * above[i]) * surroundings + std::max(0.0F, sun[i]) * of_sun;
    }
  };
  add(lit.red, &Colour::red);
  add(lit.green, &Colour::green);
  add(lit.blue, &Colour::blue);
  return lit;
}

void glow(const Colour & emission, Colours & colours)
{
  for (int i = 0; i < kBlock; ++i) {
    colours.red[i] += emission.red;
    colours.green[i] += emission.green;
    colours.blue[i] += emission.blue;
  }
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

  /// Multiplies the colours of a block by those of the texture.
  void apply(int first, int count, const Block & depths, Colours & colours) const
  {
    Block u;
    Block v;
    u_.fill(first, depths, u);
    v_.fill(first, depths, v);
    std::array<std::uint32_t, kBlock> texels{};
    for (int i = 0; i < count; ++i) {
      texels[i] = texture_->texelAt(u[i], v[i], level_);
    }
    constexpr float kScale = 1.0F / 255.0F;
    const auto channel = [](std::uint32_t texel, unsigned shift) {
      return static_cast<float>(static_cast<std::int32_t>(texel >> shift & 0xff)) * kScale;
    };
    for (int i = 0; i < kBlock; ++i) {
      colours.red[i] *= channel(texels[i], 0);
      colours.green[i] *= channel(texels[i], 8);
      colours.blue[i] *= channel(texels[i], 16);
    }
  }

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

  /// Takes from a block what the shadows leave.
  void apply(int first, int count, const Block & depths, Block & sun) const
  {
    const int last = first + count - 1;
    if (map_.isLit(
          at(0, first, depths[0]), at(1, first, depths[0]), at(0, last, depths[count - 1]),
          at(1, last, depths[count - 1]))) {
      return;
    }
    std::array<Block, 3> places;
    for (std::size_t k = 0; k < 3; ++k) {
      for (int i = 0; i < kBlock; ++i) {
        places[k][i] = at(k, first + i, depths[i]);
      }
    }
    for (int i = 0; i < count; ++i) {
      if (sun[i] > 0.0F) {
        sun[i] *= map_.light(places[0][i], places[1][i], places[2][i]);
      }
    }
  }

private:
  float at(std::size_t k, int column, float depth) const
  {
    return origin_[k] + (start_[k] + step_[k] * static_cast<float>(column)) * depth;
  }

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
  for (int column = 0; column < camera_.width; ++column) {
    depths[column] = 1.0F / nearness[column];
  }
  for (int first = 0; first < camera_.width;) {
    const std::uint32_t triangle = triangles[first];
    int end = first + 1;
    while (end < camera_.width && triangles[end] == triangle) {
      ++end;
    }
    const Run run{first, end, row};
    if (triangle == Raster::kNothing) {
      std::fill(depths + first, depths + end, std::numeric_limits<float>::infinity());
      shadeSky(run, colours);
    } else {
      shadeRun(run, triangle, rays, colours, depths);
    }
    first = end;
  }
}

void Shading::shadeSky(const Run & run, std::uint8_t * colours) const
{
  const Vec3 start = pose_.turned(camera_.ray(run.first, run.row));
  const Vec3 step = pose_.turned({0.0, -1.0 / camera_.focal_x, 0.0});
  for (int first = 0; first < run.end - run.first; first += kBlock) {
    Colours sky;
    for (int i = 0; i < kBlock; ++i) {
      const Vec3 direction = start + static_cast<double>(first + i) * step;
      const double climb = std::max(0.0, direction.z / norm(direction));
      const auto share = static_cast<float>(climb * (2.0 - climb));
      const auto mixed = [share](float low, float high) { return (1.0F - share) * low + share * high; };
      sky.red[i] = mixed(light_.horizon.red, light_.zenith.red);
      sky.green[i] = mixed(light_.horizon.green, light_.zenith.green);
      sky.blue[i] = mixed(light_.horizon.blue, light_.zenith.blue);
    }
    sky.write(std::min(kBlock, run.end - run.first - first), colours + 3 * (run.first + first));
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
  for (int column = run.first; column < run.end;) {
    const int first = column - run.first;
    const int count = std::min(run.end, (column / kBlock + 1) * kBlock) - column;
    Block depth{};
    std::copy_n(depths + column, count, depth.begin());
    Block sun;
    Block above;
    to_sun.fill(first, depth, sun);
    upwards.fill(first, depth, above);
    for (const MapRay & ray : rays) {
      const Vec3 origin = ray.map->mapFromWorld()(pose_.offset + ray.map->lift() * lighting.normal);
      ShadowRow(*ray.map, origin, ray.start + static_cast<double>(run.first) * ray.step, ray.step)
        .apply(first, count, depth, sun);
    }
    Colours lit = litBy(light_, material.diffuse, sun, above);
    if (texture) {
      texture.chooseLevel(first, depth[0]);
      texture.apply(first, count, depth, lit);
    }
    glow(material.emission, lit);
    lit.write(count, colours + 3 * column);
    column += count;
  }
}
}  // namespace f1tenth_sim2d
