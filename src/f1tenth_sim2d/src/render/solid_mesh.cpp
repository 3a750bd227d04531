#include "render/solid_mesh.h"

#include <algorithm>
#include <cmath>

namespace f1tenth_sim2d
{
namespace
{
constexpr std::size_t kSegments = 32;               // of a full circle
constexpr double kCosine = 0.98078528040323044913;  // of a segment
constexpr double kSine = 0.19509032201612826785;

struct Turn
{
  double cosine;
  double sine;
};

/// The directions of a circle's corners, the first one again at the end.
const std::vector<Turn> & circle()
{
  static const std::vector<Turn> turns = [] {
    std::vector<Turn> corners{{1.0, 0.0}};
    while (corners.size() < kSegments) {
      const Turn & last = corners.back();
      corners.push_back({last.cosine * kCosine - last.sine * kSine, last.sine * kCosine + last.cosine * kSine});
    }
    corners.push_back(corners.front());
    return corners;
  }();
  return turns;
}

class MeshBuilder
{
public:
  explicit MeshBuilder(bool is_closed) { mesh_->is_closed = is_closed; }

  std::uint32_t corner(const Vec3 & place, const Vec3 & normal, double u, double v)
  {
    mesh_->corners.push_back(place);
    mesh_->normals.push_back(normal);
    mesh_->texture_points.push_back({static_cast<float>(u), static_cast<float>(v)});
    return static_cast<std::uint32_t>(mesh_->corners.size() - 1);
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { mesh_->triangles.push_back({a, b, c}); }

  /// A parallelogram, counter-clockwise from its lower left corner.
  void face(const Vec3 & corner_place, const Vec3 & across, const Vec3 & up, const TextureScale & scale)
  {
    const Vec3 normal = normalized(cross(across, up));
    const double u = scale.tile > 0.0 ? norm(across) / scale.tile : 1.0;
    const double v = scale.tile > 0.0 ? norm(up) / scale.tile : 1.0;
    const std::uint32_t a = corner(corner_place, normal, 0.0, 0.0);
    const std::uint32_t b = corner(corner_place + across, normal, u, 0.0);
    const std::uint32_t c = corner(corner_place + across + up, normal, u, v);
    const std::uint32_t d = corner(corner_place + up, normal, 0.0, v);
    triangle(a, b, c);
    triangle(a, c, d);
  }

  /// A disc at a height, seen from above or from below.
  void disc(double radius, double z, double side)
  {
    const Vec3 normal{0.0, 0.0, side};
    const std::uint32_t middle = corner({0.0, 0.0, z}, normal, 0.5, 0.5);
    for (const Turn & turn : circle()) {
      const std::uint32_t next = corner(
        {radius * turn.cosine, radius * turn.sine, z}, normal, 0.5 + 0.5 * turn.cosine, 0.5 + 0.5 * side * turn.sine);
      if (next > middle + 1) {
        triangle(middle, side > 0.0 ? next - 1 : next, side > 0.0 ? next : next - 1);
      }
    }
  }

  /// A body of rings around the z axis.
  struct Ring
  {
    double radius;
    double z;
    double outwards;  ///< of the normal
    double upwards;   ///< of the normal
    double v;
  };
  /// @param rings  from the lowest to the highest
  void rings(const std::vector<Ring> & rings, double u_of_turn)
  {
    const auto first = static_cast<std::uint32_t>(mesh_->corners.size());
    constexpr auto kCorners = static_cast<std::uint32_t>(kSegments + 1);
    for (const Ring & ring : rings) {
      for (std::size_t i = 0; i < kCorners; ++i) {
        const Turn & turn = circle()[i];
        corner(
          {ring.radius * turn.cosine, ring.radius * turn.sine, ring.z},
          {ring.outwards * turn.cosine, ring.outwards * turn.sine, ring.upwards},
          u_of_turn * static_cast<double>(i) / kSegments, ring.v);
      }
    }
    for (std::uint32_t ring = 0; ring + 1 < rings.size(); ++ring) {
      for (std::uint32_t i = 0; i + 1 < kCorners; ++i) {
        const std::uint32_t a = first + ring * kCorners + i;
        triangle(a, a + 1, a + kCorners + 1);
        triangle(a, a + kCorners + 1, a + kCorners);
      }
    }
  }

  std::shared_ptr<const SurfaceMesh> take()
  {
    enclose(*mesh_);
    return mesh_;
  }
  SurfaceMesh & mesh() { return *mesh_; }

private:
  std::shared_ptr<SurfaceMesh> mesh_ = std::make_shared<SurfaceMesh>();
};

/// Rings of a ball, from pole to pole; the upper half is moved up and the lower half down.
std::vector<MeshBuilder::Ring> ballRings(double radius, double half_length)
{
  std::vector<MeshBuilder::Ring> rings;
  constexpr std::size_t kQuarter = kSegments / 4;
  for (std::size_t i = 0; i <= 2 * kQuarter; ++i) {
    // From straight down over level to straight up.
    const Turn & turn = circle()[(i + 3 * kQuarter) % kSegments];
    const double outwards = i == 0 || i == 2 * kQuarter ? 0.0 : turn.cosine;
    const double v = static_cast<double>(i) / (2 * kQuarter);
    if (i == kQuarter && half_length > 0.0) {
      rings.push_back({radius, -half_length, 1.0, 0.0, v});
    }
    const double shift = i < kQuarter ? -half_length : half_length;
    rings.push_back({radius * outwards, radius * turn.sine + shift, outwards, turn.sine, v});
  }
  return rings;
}

double turnsOf(double circumference, const TextureScale & scale)
{
  return scale.tile > 0.0 ? std::max(1.0, std::floor(circumference / scale.tile + 0.5)) : 1.0;
}

std::shared_ptr<const SurfaceMesh> ball(double radius, double half_length, const TextureScale & scale)
{
  MeshBuilder builder(true);
  builder.rings(ballRings(radius, half_length), turnsOf(2.0 * M_PI * radius, scale));
  return builder.take();
}

/// The area of an outline's convex pieces at a height, seen from above or from below.
void addArea(const Polyline & polyline, double z, double side, const TextureScale & scale, MeshBuilder & builder)
{
  const double tile = scale.tile > 0.0 ? scale.tile : 1.0;
  for (const ConvexPolygon & piece : polyline.pieces) {
    std::uint32_t first = 0;
    for (std::size_t i = 0; i < piece.size(); ++i) {
      const std::uint32_t next =
        builder.corner({piece[i].x, piece[i].y, z}, {0.0, 0.0, side}, piece[i].x / tile, piece[i].y / tile);
      first = i == 0 ? next : first;
      if (i >= 2) {
        builder.triangle(first, side > 0.0 ? next - 1 : next, side > 0.0 ? next : next - 1);
      }
    }
  }
}
}  // namespace

std::shared_ptr<const SurfaceMesh> meshOf(const Box & box, const TextureScale & scale)
{
  const Vec3 half = 0.5 * toVec3(box.size);
  const Vec3 x{2.0 * half.x, 0.0, 0.0};
  const Vec3 y{0.0, 2.0 * half.y, 0.0};
  const Vec3 z{0.0, 0.0, 2.0 * half.z};
  const Vec3 low = -1.0 * half;
  MeshBuilder builder(true);
  builder.face(low, x, z, scale);                 // right
  builder.face(low + x, y, z, scale);             // front
  builder.face(low + x + y, -1.0 * x, z, scale);  // left
  builder.face(low + y, -1.0 * y, z, scale);      // back
  builder.face(low + z, x, y, scale);             // top
  builder.face(low + y, x, -1.0 * y, scale);      // bottom
  return builder.take();
}

std::shared_ptr<const SurfaceMesh> meshOf(const Cylinder & cylinder, const TextureScale & scale)
{
  MeshBuilder builder(true);
  const double half = 0.5 * cylinder.length;
  const double v = scale.tile > 0.0 ? cylinder.length / scale.tile : 1.0;
  builder.rings(
    {{cylinder.radius, -half, 1.0, 0.0, 0.0}, {cylinder.radius, half, 1.0, 0.0, v}},
    turnsOf(2.0 * M_PI * cylinder.radius, scale));
  builder.disc(cylinder.radius, half, 1.0);
  builder.disc(cylinder.radius, -half, -1.0);
  return builder.take();
}

std::shared_ptr<const SurfaceMesh> meshOf(const Sphere & sphere, const TextureScale & scale)
{
  return ball(sphere.radius, 0.0, scale);
}

std::shared_ptr<const SurfaceMesh> meshOf(const Capsule & capsule, const TextureScale & scale)
{
  return ball(capsule.radius, 0.5 * capsule.length, scale);
}

std::shared_ptr<const SurfaceMesh> meshOf(const Ellipsoid & ellipsoid, const TextureScale & scale)
{
  const Vec3 radii = toVec3(ellipsoid.radii);
  MeshBuilder builder(true);
  builder.rings(ballRings(1.0, 0.0), turnsOf(2.0 * M_PI * radii.x, scale));
  for (Vec3 & corner : builder.mesh().corners) {
    corner = {corner.x * radii.x, corner.y * radii.y, corner.z * radii.z};
  }
  for (Vec3 & normal : builder.mesh().normals) {
    normal = normalized({normal.x / radii.x, normal.y / radii.y, normal.z / radii.z});
  }
  return builder.take();
}

std::shared_ptr<const SurfaceMesh> meshOf(const Polyline & polyline, const TextureScale & scale)
{
  MeshBuilder builder(true);
  for (const Outline & outline : polyline.outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec2 & a = outline[i];
      const Vec2 & b = outline[(i + 1) % outline.size()];
      builder.face({a.x, a.y, 0.0}, {b.x - a.x, b.y - a.y, 0.0}, {0.0, 0.0, polyline.height}, scale);
    }
  }
  addArea(polyline, polyline.height, 1.0, scale, builder);
  addArea(polyline, 0.0, -1.0, scale, builder);
  return builder.take();
}

std::shared_ptr<const SurfaceMesh> rectangle(
  double width, double depth, const TextureScale & scale, const Transform & turn)
{
  MeshBuilder builder(true);
  builder.face(
    turn.turned({-0.5 * width, -0.5 * depth, 0.0}), turn.turned({width, 0.0, 0.0}), turn.turned({0.0, depth, 0.0}),
    scale);
  return builder.take();
}

void makeFlat(SurfaceMesh & mesh)
{
  SurfaceMesh flat;
  flat.is_closed = mesh.is_closed;
  for (std::array<std::uint32_t, 3> & triangle : mesh.triangles) {
    const auto corner = [&](std::size_t i) { return mesh.corners[triangle[i]]; };
    const Vec3 normal = normalized(cross(corner(1) - corner(0), corner(2) - corner(0)));
    for (std::uint32_t & index : triangle) {
      flat.corners.push_back(mesh.corners[index]);
      flat.normals.push_back(normal);
      if (!mesh.texture_points.empty()) {
        flat.texture_points.push_back(mesh.texture_points[index]);
      }
      index = static_cast<std::uint32_t>(flat.corners.size() - 1);
    }
  }
  flat.triangles = std::move(mesh.triangles);
  mesh = std::move(flat);
}
}  // namespace f1tenth_sim2d
