#pragma once

#include <cstdint>
#include <vector>

#include "render/linear.h"

namespace f1tenth_sim2d
{
/// A pinhole camera. The middle of the first pixel is (0, 0).
struct Pinhole
{
  int width{0};
  int height{0};
  double focal_x{0.0};   ///< pixels
  double focal_y{0.0};   ///< pixels
  double middle_x{0.0};  ///< pixels
  double middle_y{0.0};  ///< pixels
  double near{0.02};     ///< m, along the axis: what is nearer is not seen
  double far{1000.0};    ///< m, along the axis

  /// Homogeneous pixel coordinates and depth of a point of the camera's frame.
  /// @param pose  of the camera in the world: it looks along x, z is up
  Transform pixelsFromWorld(const Transform & pose) const
  {
    Transform pixels_from_camera;
    pixels_from_camera.rows = {Vec3{middle_x, -focal_x, 0.0}, Vec3{middle_y, 0.0, -focal_y}, Vec3{1.0, 0.0, 0.0}};
    return pixels_from_camera * inverseOf(pose);
  }

  /// Where a pixel looks, in the camera's frame, one metre along the axis.
  Vec3 ray(double column, double row) const { return {1.0, (middle_x - column) / focal_x, (middle_y - row) / focal_y}; }
};

/// What a camera sees, the top row first.
struct Picture
{
  int width{0};
  int height{0};
  std::vector<std::uint8_t> colours;  ///< red, green, blue
  std::vector<float> depths;          ///< m, along the axis; +inf where nothing is
};
}  // namespace f1tenth_sim2d
