#pragma once

#include "options/option.h"

namespace f1tenth_racer
{
/// How it drives behind and beside other cars. What each means is told by visitEach().
struct TrafficOptions
{
  double follow_distance{0.8};
  double follow_time{0.25};
  double others_braking{6.0};
  double passing_distance{0.15};
  double passing_lateral_part{0.7};

  template <class Self, class Visit>
  static void visitEach(Self & self, const Visit & visit)
  {
    visit(
      {"follow_distance", "m", "kept behind another: to swing out past it from a standstill takes 0.7 m",
       Option::Range::kPositive},
      self.follow_distance);
    visit({"follow_time", "s", "added to it per m/s of the other", Option::Range::kNotNegative}, self.follow_time);
    visit(
      {"others_braking", "m/s^2", "with which others may brake at any time", Option::Range::kPositive},
      self.others_braking);
    visit(
      {"passing_distance", "m", "wanted between the cars beside each other", Option::Range::kPositive},
      self.passing_distance);
    visit(
      {"passing_lateral_part", "", "of max_lateral_acceleration, beside others", Option::Range::kPart},
      self.passing_lateral_part);
  }
};
}  // namespace f1tenth_racer
