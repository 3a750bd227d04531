#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "f1tenth_sim2d/section.h"
#include "geometry/planar.h"

/// Ear clipping (Meisters 1975), then Hertel and Mehlhorn 1983: drop each diagonal whose two sides stay convex
/// together; at most four times the least number of pieces.
namespace f1tenth_sim2d
{
namespace
{
/// Corners by their index in the outline, counter-clockwise.
using Piece = std::vector<std::size_t>;
using Edge = std::pair<std::size_t, std::size_t>;

bool insideOrOn(const Vec2 & p, const Vec2 & a, const Vec2 & b, const Vec2 & c)
{
  return turn(a, b, p) >= 0.0 && turn(b, c, p) >= 0.0 && turn(c, a, p) >= 0.0;
}

bool samePoint(const Vec2 & a, const Vec2 & b)
{
  return a.x == b.x && a.y == b.y;
}

class Triangulation
{
public:
  explicit Triangulation(const Outline & outline) : outline_(outline), left_(outline.size())
  {
    for (std::size_t i = 0; i < left_.size(); ++i) {
      left_[i] = i;
    }
    while (left_.size() > 3) {
      clip(nextEar());
    }
    triangles_.push_back(left_);
  }

  const std::vector<Piece> & triangles() const { return triangles_; }
  const std::vector<Edge> & diagonals() const { return diagonals_; }

private:
  const Vec2 & corner(std::size_t i) const { return outline_[left_[i % left_.size()]]; }
  std::size_t before(std::size_t i) const { return (i + left_.size() - 1) % left_.size(); }

  bool isEar(std::size_t i) const
  {
    const Vec2 & a = corner(before(i));
    const Vec2 & b = corner(i);
    const Vec2 & c = corner(i + 1);
    return turn(a, b, c) > 0.0 && std::none_of(left_.begin(), left_.end(), [&](std::size_t other) {
             const Vec2 & p = outline_[other];
             return !samePoint(p, a) && !samePoint(p, b) && !samePoint(p, c) && insideOrOn(p, a, b, c);
           });
  }

  /// A simple outline always has an ear; where rounding hides it, the flattest corner does least harm.
  std::size_t nextEar() const
  {
    std::size_t flattest = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < left_.size(); ++i) {
      if (isEar(i)) {
        return i;
      }
      const double area = std::abs(turn(corner(before(i)), corner(i), corner(i + 1)));
      if (area < least) {
        least = area;
        flattest = i;
      }
    }
    return flattest;
  }

  void clip(std::size_t i)
  {
    const std::size_t a = left_[before(i)];
    const std::size_t c = left_[(i + 1) % left_.size()];
    triangles_.push_back({a, left_[i], c});
    diagonals_.emplace_back(a, c);
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
  }

  const Outline & outline_;
  Piece left_;
  std::vector<Piece> triangles_;
  std::vector<Edge> diagonals_;
};

class Merger
{
public:
  Merger(const Outline & outline, std::vector<Piece> pieces) : outline_(outline), pieces_(std::move(pieces))
  {
    for (std::size_t i = 0; i < pieces_.size(); ++i) {
      own(i);
    }
  }

  /// Drops a diagonal if the pieces on its two sides are convex together.
  void dropIfConvex(const Edge & diagonal)
  {
    const auto [a, b] = diagonal;
    const std::size_t left = owner_.at({a, b});
    const std::size_t right = owner_.at({b, a});
    Piece joined = startingAt(b, pieces_[left]);        // b ... a
    const Piece other = startingAt(a, pieces_[right]);  // a ... b
    const std::size_t place_of_a = joined.size() - 1;
    joined.insert(joined.end(), other.begin() + 1, other.end() - 1);
    if (isConvexAt(joined, 0) && isConvexAt(joined, place_of_a)) {
      pieces_[left] = std::move(joined);
      pieces_[right].clear();
      own(left);
    }
  }

  std::vector<ConvexPolygon> polygons() const
  {
    std::vector<ConvexPolygon> polygons;
    for (const Piece & piece : pieces_) {
      ConvexPolygon polygon;
      for (const std::size_t corner : piece) {
        polygon.push_back(outline_[corner]);
      }
      // A triangle of no area, clipped where rounding hid the ears, vanishes here.
      if (polygon = withoutRedundantCorners(std::move(polygon)); !polygon.empty()) {
        polygons.push_back(std::move(polygon));
      }
    }
    return polygons;
  }

private:
  void own(std::size_t index)
  {
    const Piece & piece = pieces_[index];
    for (std::size_t i = 0; i < piece.size(); ++i) {
      owner_[{piece[i], piece[(i + 1) % piece.size()]}] = index;
    }
  }

  static Piece startingAt(std::size_t corner, Piece piece)
  {
    std::rotate(piece.begin(), std::find(piece.begin(), piece.end(), corner), piece.end());
    return piece;
  }

  bool isConvexAt(const Piece & piece, std::size_t i) const
  {
    const std::size_t n = piece.size();
    return turn(outline_[piece[(i + n - 1) % n]], outline_[piece[i]], outline_[piece[(i + 1) % n]]) >= 0.0;
  }

  const Outline & outline_;
  std::vector<Piece> pieces_;
  std::map<Edge, std::size_t> owner_;  ///< piece to the left of a directed edge
};
}  // namespace

std::vector<ConvexPolygon> convexDecomposition(const Outline & outline)
{
  const Outline corners = withoutRedundantCorners(outline);
  if (corners.empty()) {
    return {};
  }
  const Triangulation triangulation(corners);
  Merger merger(corners, triangulation.triangles());
  for (const Edge & diagonal : triangulation.diagonals()) {
    merger.dropIfConvex(diagonal);
  }
  return merger.polygons();
}
}  // namespace f1tenth_sim2d
