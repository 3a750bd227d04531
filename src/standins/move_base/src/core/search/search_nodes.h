#pragma once

#include <vector>

#include "geometry/geometry.h"
#include "search/curves.h"

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
  /// @param area  the grid in which positions lie
  explicit SearchNodes(const GridGeometry & area);

  /// Index of the node of the pose's bin, or -1; the reference may be set to a new one.
  /// The pose must lie inside of the area.
  int & binOf(const Pose2 & pose);

  int add(const SearchNode & node)
  {
    nodes_.push_back(node);
    return static_cast<int>(nodes_.size()) - 1;
  }
  SearchNode & operator[](int index) { return nodes_[static_cast<std::size_t>(index)]; }
  const SearchNode & operator[](int index) const { return nodes_[static_cast<std::size_t>(index)]; }

private:
  GridGeometry bins_;
  std::vector<int> blocks_;  // of each position bin: its block of heading bins, or -1 as long as none is needed
  std::vector<int> headings_;
  std::vector<SearchNode> nodes_;
};
}  // namespace move_base
