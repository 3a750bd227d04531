#pragma once

namespace move_base
{
/// From low to high, m.
struct Interval
{
  double low{0.0};
  double high{0.0};
};
}  // namespace move_base
