#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/linear.h"

namespace f1tenth_sim2d
{
/// A corner of a triangle in homogeneous pixel coordinates: pixel (x / w, y / w), whose centres are whole numbers.
/// Where w is not positive it is behind the camera; triangles need not be clipped.
struct RasterCorner
{
  double x{0.0};
  double y{0.0};
  double w{1.0};
  double q{1.0};        ///< its nearness / w is interpolated linearly over the image; of two points the greater is seen
  unsigned outside{0};  ///< one bit per border of the image that it is beyond
};

/// A linear function of the pixel.
struct PixelPlane
{
  double x{0.0};
  double y{0.0};
  double constant{0.0};

  double at(int column, int row) const { return x * column + (y * row + constant); }
};

/// Three corners as functions of the pixel: each is 1 at its corner and 0 at the two others, divided by the depth w.
/// Those of two triangles with a common edge are exact opposites along it, so that each pixel is in one of them.
class TriangleSetup
{
public:
  TriangleSetup(const RasterCorner & a, const RasterCorner & b, const RasterCorner & c);

  /// False for one that is seen exactly from its edge or has no area.
  bool isVisible() const { return is_visible_; }
  /// Whether its corners run counter-clockwise in the image, seen with x to the right and y upwards.
  bool isFront() const { return determinant_ < 0.0; }
  /// The weight of a corner, without being divided by the determinant; at least 0 inside.
  const std::array<PixelPlane, 3> & edges() const { return edges_; }
  /// Of a quantity with these values at the corners: value / w.
  PixelPlane interpolated(double a, double b, double c) const;

private:
  std::array<PixelPlane, 3> edges_;
  double determinant_;
  double scale_;
  bool is_visible_;
};

/// An image in the making: for each pixel the greatest nearness so far and the triangle that has it.
class Raster
{
public:
  static constexpr std::uint32_t kNothing = 0xffffffff;

  /// Empties it. Nothing is drawn whose nearness is not within these bounds.
  void clear(int width, int height, float least, float greatest);
  /// Marks the borders that a corner is beyond.
  void locate(RasterCorner & corner) const;
  /// @param with_back  whether it is also seen from behind
  /// @return whether it may be seen
  bool draw(
    const RasterCorner & a, const RasterCorner & b, const RasterCorner & c, bool with_back, std::uint32_t triangle);

  int width() const { return width_; }
  int height() const { return height_; }
  const float * nearness(int row) const { return &nearness_[rowStart(row)]; }
  const std::uint32_t * triangles(int row) const { return &triangles_[rowStart(row)]; }

private:
  struct Rows
  {
    int first;
    int end;
  };

  std::size_t rowStart(int row) const { return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_); }
  Rows rowsOf(const RasterCorner & a, const RasterCorner & b, const RasterCorner & c) const;

  int width_{0};
  int height_{0};
  Rows drawn_{0, 0};  ///< all others are empty
  float least_{0.0F};
  float greatest_{0.0F};
  std::vector<float> nearness_;
  std::vector<std::uint32_t> triangles_;
};
}  // namespace f1tenth_sim2d
