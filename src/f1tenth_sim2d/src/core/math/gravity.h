#pragma once

namespace f1tenth_sim2d
{
/// m/s^2, in the tyre loads of the vehicle models, whatever the world says: their coefficients were identified with it.
constexpr double kGravity = 9.81;
}  // namespace f1tenth_sim2d
