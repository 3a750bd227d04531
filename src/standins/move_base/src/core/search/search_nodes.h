#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "move_base/map/geometry.h"
#include "move_base/search/curves.h"

namespace move_base
{
/// A state of the hybrid A*: a pose that was reached, and how.
struct SearchNode
{
  Pose2 pose;
  double cost{0.0};  ///< from the start
  int parent{-1};
  Arc arc;  ///< from the parent
  bool closed{false};
  bool at_goal{false};  ///< reached by a shortest curve instead of by arc
};

/// All nodes of a search; at most one open or closed node for each bin of position and heading.
class SearchNodes
{
public:
  /// @param corner  the lower left one of the area in which positions lie
  explicit SearchNodes(const Pose2 & corner);

  /// Index of the node of the pose's bin, or -1; the reference may be set to a new one.
  int & binOf(const Pose2 & pose);

  int add(const SearchNode & node)
  {
    nodes_.push_back(node);
    return static_cast<int>(nodes_.size()) - 1;
  }
  SearchNode & operator[](int index) { return nodes_[static_cast<std::size_t>(index)]; }
  const SearchNode & operator[](int index) const { return nodes_[static_cast<std::size_t>(index)]; }

private:
  GridGeometry grid_;
  std::unordered_map<std::uint64_t, int> bins_;
  std::vector<SearchNode> nodes_;
};
}  // namespace move_base
