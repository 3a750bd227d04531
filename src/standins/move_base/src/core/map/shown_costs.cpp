#include "map/shown_costs.h"

#include <algorithm>
#include <cmath>

namespace move_base
{
void ShownCosts::startOn(const Costmap & costmap)
{
  const GridGeometry & geometry = costmap.geometry();
  cells_.assign(geometry.size(), 0);
  redraw(costmap, {{0, 0}, {geometry.width, geometry.height}});
  live_ = liveWindow(costmap);
}

void ShownCosts::update(const Costmap & costmap)
{
  const Window before = live_;
  live_ = liveWindow(costmap);
  for (const Window & window : {before, live_}) {
    if (!window.isEmpty()) {
      redraw(costmap, window);
    }
  }
}

ShownCosts::Window ShownCosts::liveWindow(const Costmap & costmap)
{
  const GridGeometry & geometry = costmap.geometry();
  if (costmap.liveLow().x > costmap.liveHigh().x) {
    return {};
  }
  const Cell low = geometry.cellAt(costmap.liveLow());
  const Cell high = geometry.cellAt(costmap.liveHigh());
  return {
    {std::max(low.x, 0), std::max(low.y, 0)},
    {std::min(high.x + 1, geometry.width), std::min(high.y + 1, geometry.height)}};
}

// Obstacles beside the window cost something in it.
void ShownCosts::redraw(const Costmap & costmap, const Window & window)
{
  const GridGeometry & geometry = costmap.geometry();
  const Inflation inflation = costmap.inflation();
  const int margin =
    static_cast<int>(std::ceil(std::max(inflation.radius, inflation.inscribed_radius) / geometry.resolution)) + 1;
  const Cell from{std::max(window.from.x - margin, 0), std::max(window.from.y - margin, 0)};
  const Cell to{std::min(window.to.x + margin, geometry.width), std::min(window.to.y + margin, geometry.height)};
  const GridGeometry part{to.x - from.x, to.y - from.y, geometry.resolution, {}};
  std::vector<std::int8_t> cells;
  cells.reserve(part.size());
  for (int y = from.y; y < to.y; ++y) {
    for (int x = from.x; x < to.x; ++x) {
      cells.push_back(costmap.occupancy(geometry.index({x, y})));
    }
  }
  cells = inflated(cells, part, inflation);
  for (int y = window.from.y; y < window.to.y; ++y) {
    const auto row = cells.begin() + static_cast<std::ptrdiff_t>(part.index({window.from.x - from.x, y - from.y}));
    std::copy_n(
      row, window.to.x - window.from.x,
      cells_.begin() + static_cast<std::ptrdiff_t>(geometry.index({window.from.x, y})));
  }
}
}  // namespace move_base
