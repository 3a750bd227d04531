#include "move_base/footprint.h"

#include <algorithm>

#include "move_base/errors.h"

namespace move_base
{
namespace
{
// More discs follow the rectangle closer and cost more look-ups: four stick out by 16 mm beside the default footprint.
constexpr int kDiscCount = 4;

double areaOf(const std::vector<Vec2> & corners)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    twice += cross(corners[i], corners[(i + 1) % corners.size()]);
  }
  return 0.5 * std::abs(twice);
}
}  // namespace

Footprint::Footprint(std::vector<Vec2> corners, double padding) : corners_(std::move(corners))
{
  if (corners_.size() < 3 || areaOf(corners_) < 1e-6) {
    throw OptionError("footprint: needs at least three corners that enclose an area");
  }
  for (Vec2 & corner : corners_) {
    corner.x += std::copysign(padding, corner.x);
    corner.y += std::copysign(padding, corner.y);
  }
  coverWithDiscs();
}

void Footprint::coverWithDiscs()
{
  const auto [rear, front] =
    std::minmax_element(corners_.begin(), corners_.end(), [](auto & a, auto & b) { return a.x < b.x; });
  const auto [right, left] =
    std::minmax_element(corners_.begin(), corners_.end(), [](auto & a, auto & b) { return a.y < b.y; });
  const double spacing = (front->x - rear->x) / kDiscCount;
  disc_radius_ = 0.5 * std::hypot(spacing, left->y - right->y);
  for (int i = 0; i < kDiscCount; ++i) {
    discs_.push_back({rear->x + (i + 0.5) * spacing, 0.5 * (left->y + right->y)});
  }
}

std::vector<Vec2> defaultFootprint()
{
  return {{0.455, 0.155}, {-0.125, 0.155}, {-0.125, -0.155}, {0.455, -0.155}};
}
}  // namespace move_base
