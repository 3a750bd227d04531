#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <vector>

#include "f1tenth_sim2d/geometry.h"

namespace f1tenth_sim2d
{
struct Appearance;

/// How something looks. Its files are read at the first look, so that what nobody sees costs nothing.
class Look
{
public:
  Look() = default;
  Look(const Look &) = delete;
  Look & operator=(const Look &) = delete;
  virtual ~Look() = default;

  /// From any thread.
  const Appearance & appearance() const;

private:
  virtual Appearance read() const = 0;

  mutable std::once_flag once_;
  mutable std::shared_ptr<const Appearance> appearance_;
};

/// A joint that turns what hangs on it.
struct Hinge
{
  std::size_t joint;      ///< index in the mechanism of the car
  Eigen::Vector3d place;  ///< m, in the frame of the car
  Eigen::Vector3d axis;   ///< unit, in the frame of the car
};

/// One <visual> element of a model or car.
struct Visual
{
  Pose3 pose;                   ///< in the frame of the model or car, joints at zero
  std::vector<Hinge> hinges{};  ///< of a car, from the body outwards
  std::shared_ptr<const Look> look{};
};
}  // namespace f1tenth_sim2d
