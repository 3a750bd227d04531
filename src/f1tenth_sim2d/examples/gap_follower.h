#pragma once

#include <workspace_support/maths/trigonometry.h>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

/// A reactive driver: steer towards the middle of the widest gap ahead, slower the harder it steers.
namespace gap_follower
{
/// What the driver looks at, and how it drives.
struct Options
{
  double field_of_view{2.6};  ///< rad, centred ahead
  double sight{5.0};          ///< m, farther away counts as free
  double bubble{0.5};         ///< m, kept clear to both sides of what is nearest
  double safe_range{1.2};     ///< m, a beam longer than that is part of a gap
  double steering_gain{0.9};  ///< steering angle per angle of the gap
  double steering_max{0.4};   ///< rad
  double speed{2.0};          ///< m/s, straight ahead
  double speed_turning{1.2};  ///< m/s, at full steering angle
};

struct Command
{
  double speed;           ///< m/s
  double steering_angle;  ///< rad
};

/// A planar scan, beam i at angle_min + i * angle_increment, rad; ranges in m.
struct Scan
{
  double angle_min;
  double angle_increment;
  const std::vector<float> & ranges;
};

class GapFollower
{
public:
  explicit GapFollower(const Options & options = {}) : options_(options) {}

  /// @param scan  at least one beam within the field of view
  Command drive(const Scan & scan)
  {
    look(scan);
    blankNearest(scan.angle_increment);
    const double angle = angleOfBestGap(scan);
    const double steering = std::clamp(options_.steering_gain * angle, -options_.steering_max, options_.steering_max);
    const double turning = std::abs(steering) / options_.steering_max;
    return {options_.speed + (options_.speed_turning - options_.speed) * turning, steering};
  }

private:
  void look(const Scan & scan)
  {
    const auto beam = [&](double angle) {
      const double index = std::round((angle - scan.angle_min) / scan.angle_increment);
      return static_cast<std::size_t>(std::clamp(index, 0.0, static_cast<double>(scan.ranges.size() - 1)));
    };
    first_ = beam(-options_.field_of_view / 2.0);
    const std::size_t last = beam(options_.field_of_view / 2.0);
    view_.resize(last - first_ + 1);
    for (std::size_t i = 0; i < view_.size(); ++i) {
      // Too near is -inf, nothing there +inf.
      view_[i] = std::clamp(static_cast<double>(scan.ranges[first_ + i]), 0.0, options_.sight);
    }
  }

  void blankNearest(double angle_increment)
  {
    const auto nearest = std::min_element(view_.begin(), view_.end());
    const double half_angle = workspace_support::maths::atan2(options_.bubble, *nearest);
    const auto reach = static_cast<std::ptrdiff_t>(half_angle / angle_increment);
    const auto place = nearest - view_.begin();
    const auto size = static_cast<std::ptrdiff_t>(view_.size());
    std::fill(
      view_.begin() + std::max<std::ptrdiff_t>(0, place - reach), view_.begin() + std::min(size, place + reach + 1),
      0.0);
  }

  /// Direction of the gap with the greatest sum of ranges; 0 if there is none.
  double angleOfBestGap(const Scan & scan) const
  {
    double best = 0.0;
    double angle = 0.0;
    for (std::size_t begin = 0; begin < view_.size(); ++begin) {
      double sum = 0.0;
      double moment = 0.0;
      std::size_t end = begin;
      for (; end < view_.size() && view_[end] > options_.safe_range; ++end) {
        sum += view_[end];
        moment += view_[end] * static_cast<double>(first_ + end);
      }
      if (sum > best) {
        best = sum;
        angle = scan.angle_min + moment / sum * scan.angle_increment;
      }
      begin = end;
    }
    return angle;
  }

  const Options options_;
  std::size_t first_{0};      // beam of view_[0]
  std::vector<double> view_;  // m
};
}  // namespace gap_follower
