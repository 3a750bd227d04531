#include "render/lens.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace f1tenth_sim2d
{
namespace
{
constexpr float kNowhere = std::numeric_limits<float>::quiet_NaN();

/// On the plane one metre ahead: x to the right, y down.
struct Ahead
{
  double x;
  double y;
};

/// Where a lens moves a point to, and how much farther it moves one beside it.
struct Bent
{
  Ahead at;
  double dx_dx;
  double dx_dy;  ///< and dy_dx
  double dy_dy;

  /// Whether it is on the side of the lens that does not fold the picture over.
  bool isUpright() const { return dx_dx + dy_dy > 0.0 && dx_dx * dy_dy - dx_dy * dx_dy > 0.0; }
};

Bent bentBy(const Distortion & distortion, const Ahead & point)
{
  const auto & [k1, k2, t1, t2, k3] = distortion;
  const auto & [x, y] = point;
  const double square = x * x + y * y;
  const double radial = 1.0 + square * (k1 + square * (k2 + square * k3));
  const double slope = 2.0 * (k1 + square * (2.0 * k2 + square * (3.0 * k3)));
  return {
    {x * radial + 2.0 * t1 * x * y + t2 * (square + 2.0 * x * x),
     y * radial + t1 * (square + 2.0 * y * y) + 2.0 * t2 * x * y},
    radial + x * x * slope + 2.0 * t1 * y + 6.0 * t2 * x,
    x * y * slope + 2.0 * (t1 * x + t2 * y),
    radial + y * y * slope + 6.0 * t1 * y + 2.0 * t2 * x};
}

/// The point that a lens moves to another one, by Newton's method; nothing if there is none.
/// @param guess  near it
std::optional<Ahead> straightened(const Distortion & distortion, const Ahead & wanted, const Ahead & guess)
{
  constexpr int kMostSteps = 20;
  constexpr double kEnough = 1e-9;  // m, a millionth of a pixel
  Ahead point = guess;
  for (int i = 0; i < kMostSteps; ++i) {
    const Bent bent = bentBy(distortion, point);
    const double x = wanted.x - bent.at.x;
    const double y = wanted.y - bent.at.y;
    if (!bent.isUpright()) {
      return std::nullopt;
    }
    if (std::abs(x) < kEnough && std::abs(y) < kEnough) {
      return point;
    }
    const double scale = 1.0 / (bent.dx_dx * bent.dy_dy - bent.dx_dy * bent.dx_dy);
    point.x += scale * (bent.dy_dy * x - bent.dx_dy * y);
    point.y += scale * (bent.dx_dx * y - bent.dx_dy * x);
  }
  return std::nullopt;
}

Ahead aheadOf(const Pinhole & camera, double column, double row)
{
  return {(column - camera.middle_x) / camera.focal_x, (row - camera.middle_y) / camera.focal_y};
}

/// The share of a bent picture's width and height that has no black border, at most 1.
double shareWithoutBorder(const Pinhole & camera, const Distortion & distortion)
{
  constexpr double kLeast = 0.1;
  const double right = 0.5 * camera.width / camera.focal_x;
  const double bottom = 0.5 * camera.height / camera.focal_y;
  double share = 1.0;
  const auto pass = [&](double column, double row) {
    const Ahead at = bentBy(distortion, aheadOf(camera, column, row)).at;
    share = std::min(share, std::max(std::abs(at.x) / right, std::abs(at.y) / bottom));
  };
  for (int column = 0; column <= camera.width; ++column) {
    pass(column - 0.5, -0.5);
    pass(column - 0.5, camera.height - 0.5);
  }
  for (int row = 0; row <= camera.height; ++row) {
    pass(-0.5, row - 0.5);
    pass(camera.width - 0.5, row - 0.5);
  }
  return std::max(kLeast, share);
}

/// A place between pixels: two columns and two rows, and how far it is from the first ones, in 256ths.
struct Between
{
  std::size_t first;
  std::size_t second;
  std::uint32_t share;

  Between(float place, int end)
  {
    const float within = std::max(0.0F, std::min(place, static_cast<float>(end - 1)));
    const int before = static_cast<int>(within);
    first = static_cast<std::size_t>(before);
    second = static_cast<std::size_t>(std::min(before + 1, end - 1));
    share = static_cast<std::uint32_t>((within - static_cast<float>(before)) * 256.0F + 0.5F);
  }
};

/// The four pixels around a place.
class Around
{
public:
  Around(float column, float row, const Picture & picture)
  : column_(column, picture.width), row_(row, picture.height), width_(static_cast<std::size_t>(picture.width))
  {
  }

  std::uint8_t colour(const std::vector<std::uint8_t> & colours, std::size_t channel) const
  {
    const auto at = [&](std::size_t row, std::size_t column) {
      return std::uint32_t{colours[3 * (row * width_ + column) + channel]};
    };
    const auto along = [&](std::size_t row) {
      return at(row, column_.first) * (256 - column_.share) + at(row, column_.second) * column_.share;
    };
    constexpr std::uint32_t kHalf = 1U << 15;
    return static_cast<std::uint8_t>(
      (along(row_.first) * (256 - row_.share) + along(row_.second) * row_.share + kHalf) >> 16);
  }

  /// That of the surface which all four show, else of the nearest pixel.
  float depth(const std::vector<float> & depths) const
  {
    constexpr float kEdge = 1.05F;  // ratio of depths beyond which two pixels do not show one surface
    const std::array<float, 4> four{
      depths[row_.first * width_ + column_.first], depths[row_.first * width_ + column_.second],
      depths[row_.second * width_ + column_.first], depths[row_.second * width_ + column_.second]};
    const auto [least, greatest] = std::minmax_element(four.begin(), four.end());
    if (!(*greatest <= kEdge * *least)) {
      return four[(row_.share >= 128 ? 2U : 0U) + (column_.share >= 128 ? 1U : 0U)];
    }
    // Of a plane, it is the inverse of the depth that is linear in the picture.
    const auto between = [](float first, float second, const Between & place) {
      return first + (second - first) * (static_cast<float>(place.share) / 256.0F);
    };
    return 1.0F /
           between(
             between(1.0F / four[0], 1.0F / four[1], column_), between(1.0F / four[2], 1.0F / four[3], column_), row_);
  }

private:
  Between column_;
  Between row_;
  std::size_t width_;
};
}  // namespace

Lens::Lens(const Pinhole & straight, const Distortion & distortion, bool crops)
: straight_(straight), bent_(straight), distortion_(distortion)
{
  const double share = crops ? shareWithoutBorder(straight, distortion) : 1.0;
  bent_.focal_x /= share;
  bent_.focal_y /= share;
}

const std::vector<Lens::Source> & Lens::sources() const
{
  std::call_once(found_, [this] { sources_ = findSources(); });
  return sources_;
}

std::vector<Lens::Source> Lens::findSources() const
{
  std::vector<Source> sources;
  sources.reserve(static_cast<std::size_t>(bent_.width) * static_cast<std::size_t>(bent_.height));
  for (int row = 0; row < bent_.height; ++row) {
    for (int column = 0; column < bent_.width; ++column) {
      const Ahead wanted = aheadOf(bent_, column, row);
      const std::optional<Ahead> found = straightened(distortion_, wanted, wanted);
      Source source{kNowhere, kNowhere};
      if (found) {
        const double from_column = straight_.middle_x + straight_.focal_x * found->x;
        const double from_row = straight_.middle_y + straight_.focal_y * found->y;
        if (
          from_column >= -0.5 && from_column <= straight_.width - 0.5 && from_row >= -0.5 &&
          from_row <= straight_.height - 0.5) {
          source = {static_cast<float>(from_column), static_cast<float>(from_row)};
        }
      }
      sources.push_back(source);
    }
  }
  return sources;
}

void Lens::bend(Picture & picture) const
{
  const Picture straight = picture;
  const std::vector<Source> & from = sources();
  for (std::size_t i = 0; i < from.size(); ++i) {
    const bool is_seen = !std::isnan(from[i].column);
    const Around around(is_seen ? from[i].column : 0.0F, is_seen ? from[i].row : 0.0F, straight);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      picture.colours[3 * i + channel] = is_seen ? around.colour(straight.colours, channel) : std::uint8_t{0};
    }
    picture.depths[i] = is_seen ? around.depth(straight.depths) : std::numeric_limits<float>::infinity();
  }
}

Vec3 Lens::ray(std::size_t pixel) const
{
  const Source & source = sources()[pixel];
  return straight_.ray(source.column, source.row);
}
}  // namespace f1tenth_sim2d
