#include "conversions.h"

namespace gmapping
{
nav_msgs::OccupancyGrid toOccupancyGrid(const OccupancyGrid & grid, const std_msgs::Header & header)
{
  nav_msgs::OccupancyGrid message;
  message.header = header;
  message.info.map_load_time = header.stamp;
  message.info.resolution = static_cast<float>(grid.resolution);
  message.info.width = static_cast<std::uint32_t>(grid.width);
  message.info.height = static_cast<std::uint32_t>(grid.height);
  message.info.origin.position.x = grid.x;
  message.info.origin.position.y = grid.y;
  message.info.origin.orientation.w = 1.0;
  message.data.assign(grid.cells.begin(), grid.cells.end());
  return message;
}
}  // namespace gmapping
