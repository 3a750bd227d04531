#include "costmap_publisher.h"

#include <geometry_msgs/PolygonStamped.h>
#include <map_msgs/OccupancyGridUpdate.h>

#include <algorithm>
#include <iterator>
#include <utility>

namespace move_base
{
namespace
{
// The smallest rectangle with all cells that differ; without cells where none does. Both grids have the same size.
map_msgs::OccupancyGridUpdate changeOf(const nav_msgs::OccupancyGrid & before, const nav_msgs::OccupancyGrid & now)
{
  const auto width = static_cast<std::ptrdiff_t>(now.info.width);
  std::ptrdiff_t left = width;
  std::ptrdiff_t right = 0;  // beyond the last
  std::ptrdiff_t low = 0;
  std::ptrdiff_t high = 0;  // beyond the last
  for (std::ptrdiff_t y = 0; y < static_cast<std::ptrdiff_t>(now.info.height); ++y) {
    const auto row = now.data.begin() + y * width;
    const auto old = before.data.begin() + y * width;
    const std::ptrdiff_t first = std::mismatch(row, row + width, old).first - row;
    if (first == width) {
      continue;
    }
    const auto end = std::make_reverse_iterator(row + width);
    const auto last = std::mismatch(end, end + width, std::make_reverse_iterator(old + width)).first;
    left = std::min(left, first);
    right = std::max(right, last.base() - row);
    low = high == 0 ? y : low;
    high = y + 1;
  }
  map_msgs::OccupancyGridUpdate change;
  change.header = now.header;
  change.x = static_cast<std::int32_t>(left);
  change.y = static_cast<std::int32_t>(low);
  change.width = static_cast<std::uint32_t>(std::max<std::ptrdiff_t>(right - left, 0));
  change.height = static_cast<std::uint32_t>(high - low);
  for (std::ptrdiff_t y = low; y < high; ++y) {
    const auto row = now.data.begin() + y * width;
    change.data.insert(change.data.end(), row + left, row + right);
  }
  return change;
}
}  // namespace

CostmapPublisher::CostmapPublisher(
  ros::NodeHandle & node, const std::string & costmap, double frequency, bool always_whole)
: always_whole_(always_whole),
  whole_{
    node.advertise<nav_msgs::OccupancyGrid>(
      costmap + "/costmap", 1, [this](const ros::SingleSubscriberPublisher &) { newcomer_ = true; }),
    frequency,
    {}},
  updates_(node.advertise<map_msgs::OccupancyGridUpdate>(costmap + "/costmap_updates", 1)),
  footprint_{node.advertise<geometry_msgs::PolygonStamped>(costmap + "/footprint", 1), frequency, {}}
{
}

void CostmapPublisher::publish(nav_msgs::OccupancyGrid costs)
{
  if (always_whole_ || newcomer_ || costs.info != shown_.info) {
    whole_.publisher.publish(costs);
    newcomer_ = false;
  } else if (const auto change = changeOf(shown_, costs); !change.data.empty()) {
    updates_.publish(change);
  }
  shown_ = std::move(costs);
}
}  // namespace move_base
