#include "search/cost_to_go.h"

#include <array>
#include <limits>

namespace move_base
{
namespace
{
// Fine enough for the gaps a car fits through, coarse enough to be quick.
constexpr double kCoarseResolution = 0.1;
constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr float kNotPriced = -1.0F;

struct Move
{
  int dx;
  int dy;
  double length;
};
constexpr double kDiagonal = 1.4142135623730951;
constexpr std::array<Move, 8> kMoves{{
  {1, 0, 1.0},
  {0, 1, 1.0},
  {-1, 0, 1.0},
  {0, -1, 1.0},
  {1, 1, kDiagonal},
  {-1, 1, kDiagonal},
  {-1, -1, kDiagonal},
  {1, -1, kDiagonal},
}};

GridGeometry coarser(const GridGeometry & fine)
{
  GridGeometry coarse = fine;
  coarse.resolution = std::max(fine.resolution, kCoarseResolution);
  coarse.width = static_cast<int>(std::ceil(fine.width * fine.resolution / coarse.resolution));
  coarse.height = static_cast<int>(std::ceil(fine.height * fine.resolution / coarse.resolution));
  return coarse;
}
}  // namespace

CostToGo::CostToGo(const Costmap & costmap, const Vec2 & goal, const std::optional<Gate> & gate)
: costmap_(costmap),
  gate_(gate),
  geometry_(coarser(costmap.geometry())),
  costs_(geometry_.size(), kInfinite),
  prices_(geometry_.size(), kNotPriced),
  closed_(geometry_.size(), false)
{
  const Cell cell = geometry_.cellAt(goal);
  if (geometry_.contains(cell)) {
    costs_[geometry_.index(cell)] = 0.0;
    open_.push({0.0, geometry_.index(cell)});
  }
}

double CostToGo::at(const Vec2 & point)
{
  const Cell cell = geometry_.cellAt(point);
  if (!geometry_.contains(cell)) {
    return kInfinite;
  }
  const std::size_t index = geometry_.index(cell);
  searchUntilClosed(index);
  return costs_[index];
}

void CostToGo::searchUntilClosed(std::size_t cell)
{
  while (!closed_[cell] && !open_.empty()) {
    const Entry entry = open_.top();
    open_.pop();
    if (!closed_[entry.cell]) {
      closed_[entry.cell] = true;
      expand(entry);
    }
  }
}

void CostToGo::expand(const Entry & entry)
{
  const Cell from = geometry_.cell(entry.cell);
  for (const Move & move : kMoves) {
    const Cell to{from.x + move.dx, from.y + move.dy};
    if (!geometry_.contains(to)) {
      continue;
    }
    const std::size_t index = geometry_.index(to);
    const double cost = entry.cost + move.length * geometry_.resolution * pricePerMetre(index);
    if (cost < costs_[index]) {
      costs_[index] = cost;
      open_.push({cost, index});
    }
  }
}

double CostToGo::pricePerMetre(std::size_t cell)
{
  if (prices_[cell] == kNotPriced) {
    const Vec2 point = geometry_.centre(geometry_.cell(cell));
    const double room = costmap_.obstacleDistance(point);
    const double clearance = room - costmap_.footprint().halfWidth();
    prices_[cell] = isClosed(point, room) ? std::numeric_limits<float>::infinity()
                                          : static_cast<float>(1.0 + costmap_.proximityCost(clearance));
  }
  return prices_[cell];
}

bool CostToGo::isClosed(const Vec2 & point, double room) const
{
  return room < kPointClearance || (gate_ && distanceToLine(gate_->left, gate_->right, point) <= geometry_.resolution);
}
}  // namespace move_base
