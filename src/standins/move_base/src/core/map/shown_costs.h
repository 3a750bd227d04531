#pragma once

#include <cstdint>
#include <vector>

#include "map/costmap.h"

namespace move_base
{
/// Costs of a whole costmap as messages show them, kept up to date around what the lidar sees.
class ShownCosts
{
public:
  /// Takes another map.
  void startOn(const Costmap & costmap);
  /// Takes what has changed since, on the same map.
  void update(const Costmap & costmap);

  /// Row by row, as of inflated().
  const std::vector<std::int8_t> & cells() const { return cells_; }

private:
  struct Window
  {
    Cell from;
    Cell to;  // beyond the last

    bool isEmpty() const { return from.x >= to.x || from.y >= to.y; }
  };
  static Window liveWindow(const Costmap & costmap);
  void redraw(const Costmap & costmap, const Window & window);

  std::vector<std::int8_t> cells_;
  Window live_;  // what was drawn of what the lidar sees
};
}  // namespace move_base
