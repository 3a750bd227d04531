#include "move_base/map/footprint.h"

#include <workspace_support/errors.h>

#include <algorithm>
#include <cmath>

namespace move_base
{
namespace
{
// More discs follow the rectangle closer and cost more look-ups.
constexpr int kDiscsAlong = 3;
constexpr int kDiscsAtEnds = 4;
static_assert(kDiscsAlong + kDiscsAtEnds == Footprint::kDiscs);
constexpr double kEndPart = 0.375;  // length of each end in widths of the car

// One disc for each of count equal parts of a rectangle's length. Returns the place of the next disc.
Disc * coverRectangle(const Vec2 & low, const Vec2 & high, int count, Disc * disc)
{
  const double part = (high.x - low.x) / count;
  const double radius = 0.5 * maths::hypot(part, high.y - low.y);
  for (int i = 0; i < count; ++i) {
    *disc++ = {{low.x + (i + 0.5) * part, 0.5 * (low.y + high.y)}, radius};
  }
  return disc;
}

double areaOf(const std::vector<Vec2> & corners)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    twice += cross(corners[i], corners[(i + 1) % corners.size()]);
  }
  return 0.5 * std::abs(twice);
}

double inscribedRadiusOf(const std::vector<Vec2> & corners)
{
  double radius = HUGE_VAL;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    radius = std::min(radius, distanceToLine(corners[i], corners[(i + 1) % corners.size()], {}));
  }
  return radius;
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
  inscribed_radius_ = inscribedRadiusOf(corners_);
  coverWithDiscs();
}

void Footprint::coverWithDiscs()
{
  const auto [rear, front] =
    std::minmax_element(corners_.begin(), corners_.end(), [](auto & a, auto & b) { return a.x < b.x; });
  const auto [right, left] =
    std::minmax_element(corners_.begin(), corners_.end(), [](auto & a, auto & b) { return a.y < b.y; });
  const double width = left->y - right->y;
  const double middle = 0.5 * (left->y + right->y);
  const double end = std::min(kEndPart * width, 0.25 * (front->x - rear->x));
  half_width_ = 0.5 * width;
  rear_ = rear->x;
  front_ = front->x;
  Disc * disc = coverRectangle({rear->x + end, right->y}, {front->x - end, left->y}, kDiscsAlong, discs_.data());
  for (const double x : {rear->x, front->x - end}) {
    disc = coverRectangle({x, right->y}, {x + end, middle}, 1, disc);
    disc = coverRectangle({x, middle}, {x + end, left->y}, 1, disc);
  }
  around_.centre = {0.5 * (rear->x + front->x), middle};
  for (const Disc & each : discs_) {
    around_.radius = std::max(around_.radius, distance(each.centre, around_.centre) + each.radius);
  }
}

std::vector<Vec2> defaultFootprint()
{
  return {{0.455, 0.155}, {-0.125, 0.155}, {-0.125, -0.155}, {0.455, -0.155}};
}
}  // namespace move_base
