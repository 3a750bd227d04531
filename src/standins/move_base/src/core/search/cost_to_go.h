#pragma once

#include <functional>
#include <optional>
#include <queue>
#include <vector>

#include "move_base/map/costmap.h"

namespace move_base
{
/// Free room around a point that is led to a goal, m. It may pass where the car does not fit: less than half of the
/// car's width keeps the lead optimistic.
constexpr double kPointClearance = 0.1;

/// A bar across a road.
struct Gate
{
  Vec2 left;
  Vec2 right;
};

/// What it costs a point to move to the goal: Dijkstra from the goal over a coarse grid, as far as it is asked for.
/// Steers the search of the hybrid A*, which knows what a car can do.
class CostToGo
{
public:
  /// @param gate  closed in addition to the obstacles
  CostToGo(const Costmap & costmap, const Vec2 & goal, const std::optional<Gate> & gate = {});

  /// Cost in metres of free road; infinite where the goal cannot be reached. Continues the search if need be.
  double at(const Vec2 & point);

private:
  struct Entry
  {
    double cost;
    std::size_t cell;
    bool operator>(const Entry & other) const { return cost != other.cost ? cost > other.cost : cell > other.cell; }
  };

  void searchUntilClosed(std::size_t cell);
  void expand(const Entry & entry);
  double pricePerMetre(std::size_t cell);
  bool isClosed(const Vec2 & point, double room) const;

  const Costmap & costmap_;
  std::optional<Gate> gate_;
  GridGeometry geometry_;
  std::vector<double> costs_;
  std::vector<float> prices_;
  std::vector<bool> closed_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};
}  // namespace move_base
