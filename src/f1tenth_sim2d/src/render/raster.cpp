#include "render/raster.h"

#include <algorithm>
#include <cmath>

namespace f1tenth_sim2d
{
namespace
{
/// Below this share of its greatest possible value a determinant is rounding: the triangle is seen from its edge.
constexpr double kLeastDeterminant = 1e-10;
/// Pixels by which a bounding box is too large, so that its own rounding loses nothing.
constexpr double kMargin = 1e-6;

PixelPlane edgeOf(const RasterCorner & a, const RasterCorner & b)
{
  return {a.y * b.w - a.w * b.y, a.w * b.x - a.x * b.w, a.x * b.y - a.y * b.x};
}

/// The least whole number that is not below a number, which is brought within 0 and end first.
int roundedUp(double number, int end)
{
  const double within = std::max(0.0, std::min(number, static_cast<double>(end)));
  const int truncated = static_cast<int>(within);
  return truncated + (truncated < within ? 1 : 0);
}

/// The columns of a row that are inside of all edges: those at the left of an edge belong to the triangle, those at the
/// right do not, so that of two triangles with a common edge exactly one has a pixel on it.
class Span
{
public:
  Span(const std::array<PixelPlane, 3> & edges, int width) : edges_(edges), width_(width)
  {
    for (std::size_t i = 0; i < 3; ++i) {
      inverse_[i] = 1.0 / edges_[i].x;
    }
  }

  void find(int row)
  {
    first = 0;
    end = width_;
    for (std::size_t i = 0; i < 3; ++i) {
      const PixelPlane & edge = edges_[i];
      const double at_start = edge.y * row + edge.constant;
      if (edge.x > 0.0) {
        first = std::max(first, roundedUp(-at_start * inverse_[i], width_));
      } else if (edge.x < 0.0) {
        end = std::min(end, roundedUp(-at_start * inverse_[i], width_));
      } else if (at_start < 0.0 || (at_start == 0.0 && edge.y < 0.0)) {
        end = 0;
      }
    }
  }

  int first{0};
  int end{0};

private:
  const std::array<PixelPlane, 3> & edges_;
  std::array<double, 3> inverse_{};
  const int width_;
};

void drawSpan(
  int count, float start, float step, float greatest, std::uint32_t triangle, float * nearness,
  std::uint32_t * triangles)
{
  for (int i = 0; i < count; ++i) {
    const float here = start + step * static_cast<float>(i);
    const bool is_seen = (here > nearness[i]) & (here <= greatest);
    nearness[i] = is_seen ? here : nearness[i];
    triangles[i] = is_seen ? triangle : triangles[i];
  }
}
}  // namespace

TriangleSetup::TriangleSetup(const RasterCorner & a, const RasterCorner & b, const RasterCorner & c)
: edges_{edgeOf(b, c), edgeOf(c, a), edgeOf(a, b)}
{
  const double along_x = a.x * edges_[0].x;
  const double along_y = a.y * edges_[0].y;
  const double along_w = a.w * edges_[0].constant;
  determinant_ = (along_x + along_y) + along_w;
  const double greatest = std::max({std::abs(along_x), std::abs(along_y), std::abs(along_w)});
  is_visible_ = std::abs(determinant_) > kLeastDeterminant * greatest && std::isfinite(determinant_);
  scale_ = 1.0 / std::abs(determinant_);
  if (determinant_ < 0.0) {
    for (PixelPlane & edge : edges_) {
      edge = {-edge.x, -edge.y, -edge.constant};
    }
  }
}

PixelPlane TriangleSetup::interpolated(double a, double b, double c) const
{
  const auto sum = [&](double PixelPlane::*part) {
    return scale_ * ((a * edges_[0].*part + b * edges_[1].*part) + c * edges_[2].*part);
  };
  return {sum(&PixelPlane::x), sum(&PixelPlane::y), sum(&PixelPlane::constant)};
}

void Raster::clear(int width, int height, float least, float greatest)
{
  const bool is_other = width != width_ || height != height_ || least != least_;
  width_ = width;
  height_ = height;
  least_ = least;
  greatest_ = greatest;
  if (is_other) {
    drawn_ = {0, height};
    nearness_.resize(rowStart(height));
    triangles_.resize(rowStart(height));
  }
  if (drawn_.first < drawn_.end) {
    const auto first = static_cast<std::ptrdiff_t>(rowStart(drawn_.first));
    const auto end = static_cast<std::ptrdiff_t>(rowStart(drawn_.end));
    std::fill(nearness_.begin() + first, nearness_.begin() + end, least);
    std::fill(triangles_.begin() + first, triangles_.begin() + end, kNothing);
  }
  drawn_ = {height, 0};
}

void Raster::locate(RasterCorner & corner) const
{
  corner.outside = (corner.x < -corner.w ? 1U : 0U) | (corner.x > width_ * corner.w ? 2U : 0U) |
                   (corner.y < -corner.w ? 4U : 0U) | (corner.y > height_ * corner.w ? 8U : 0U) |
                   (corner.w <= 0.0 ? 16U : 0U);
}

Raster::Rows Raster::rowsOf(const RasterCorner & a, const RasterCorner & b, const RasterCorner & c) const
{
  if (((a.outside | b.outside | c.outside) & 16U) != 0) {
    return {0, height_};
  }
  const std::array<double, 3> x{a.x / a.w, b.x / b.w, c.x / c.w};
  const std::array<double, 3> y{a.y / a.w, b.y / b.w, c.y / c.w};
  const auto [left, right] = std::minmax({x[0], x[1], x[2]});
  if (roundedUp(left - kMargin, width_) == roundedUp(right + kMargin, width_)) {
    return {0, 0};  // between two columns, as most triangles of a far mesh
  }
  const auto [top, bottom] = std::minmax({y[0], y[1], y[2]});
  return {roundedUp(top - kMargin, height_), roundedUp(bottom + kMargin, height_)};
}

bool Raster::draw(
  const RasterCorner & a, const RasterCorner & b, const RasterCorner & c, bool with_back, std::uint32_t triangle)
{
  if ((a.outside & b.outside & c.outside) != 0) {
    return false;
  }
  const Rows rows = rowsOf(a, b, c);
  if (rows.first >= rows.end) {
    return false;
  }
  const TriangleSetup setup(a, b, c);
  if (!setup.isVisible() || !(with_back || setup.isFront())) {
    return false;
  }
  drawn_ = {std::min(drawn_.first, rows.first), std::max(drawn_.end, rows.end)};
  const PixelPlane nearness = setup.interpolated(a.q, b.q, c.q);
  const auto step = static_cast<float>(nearness.x);
  Span span(setup.edges(), width_);
  for (int row = rows.first; row < rows.end; ++row) {
    span.find(row);
    if (span.first < span.end) {
      const std::size_t start = rowStart(row) + static_cast<std::size_t>(span.first);
      drawSpan(
        span.end - span.first, static_cast<float>(nearness.at(span.first, row)), step, greatest_, triangle,
        &nearness_[start], &triangles_[start]);
    }
  }
  return true;
}
}  // namespace f1tenth_sim2d
