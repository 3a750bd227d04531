#pragma once

#include <optional>

#include "cell_map.h"

namespace gmapping
{
/// Weighted mean and covariance of points, and the straight line through them if they form one.
class Moments
{
public:
  void add(const Vec2 & point, double weight);
  Vec2 mean() const { return {x_ / weight_, y_ / weight_}; }  ///< m
  /// Unit vector across the line.
  std::optional<Vec2> normal() const;

private:
  int count_{0};
  double weight_{0.0};
  double x_{0.0};
  double y_{0.0};
  double xx_{0.0};
  double xy_{0.0};
  double yy_{0.0};
};
}  // namespace gmapping
