#pragma once

namespace f1tenth_sim2d
{
constexpr double kPi = 3.14159265358979323846;
}  // namespace f1tenth_sim2d
