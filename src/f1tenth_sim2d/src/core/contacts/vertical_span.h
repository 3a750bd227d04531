#pragma once

#include "f1tenth_sim2d/world_model.h"

namespace f1tenth_sim2d
{
/// Heights that a solid reaches over, m. Empty if bottom > top.
struct VerticalSpan
{
  double bottom{0.0};
  double top{0.0};
};

/// @param pose  of the solid in the frame in which the heights are given. A Plane has an empty span.
VerticalSpan verticalSpan(const Solid & solid, const Pose3 & pose);

/// Whether bodies of these spans can touch. Less than a millimetre in common does not count: wheels stand on floors.
bool overlap(const VerticalSpan & a, const VerticalSpan & b);

/// Whether the solid looks the same from above whatever part of its height is taken.
bool isUprightPrism(const Solid & solid, const Pose3 & pose);
}  // namespace f1tenth_sim2d
