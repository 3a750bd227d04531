#pragma once

#include <array>
#include <mutex>
#include <vector>

#include "render/camera.h"

namespace f1tenth_sim2d
{
/// Coefficients k1, k2, t1, t2, k3 of Brown's model of a lens: "plumb_bob" of sensor_msgs/CameraInfo.
using Distortion = std::array<double, 5>;

/// Bends the picture of a pinhole camera as a lens does.
class Lens
{
public:
  /// @param straight  the camera without lens
  /// @param crops     whether the picture is enlarged so far that the black border of a barrel is outside of it
  Lens(const Pinhole & straight, const Distortion & distortion, bool crops);

  const Pinhole & straight() const { return straight_; }
  /// The camera to which the bent picture belongs, before its lens: its focal length is greater if it crops.
  const Pinhole & bent() const { return bent_; }
  const Distortion & distortion() const { return distortion_; }

  /// @param picture  of straight(), which becomes the bent one: black and infinitely far where straight() sees nothing
  void bend(Picture & picture) const;
  /// Where a pixel of the bent picture looks, as Pinhole::ray; not a number in the black border.
  Vec3 ray(std::size_t pixel) const;

private:
  /// Column and row in the straight picture.
  struct Source
  {
    float column;
    float row;
  };

  /// Of each pixel of the bent picture. Computed by whoever asks first.
  const std::vector<Source> & sources() const;
  std::vector<Source> findSources() const;

  Pinhole straight_;
  Pinhole bent_;
  Distortion distortion_;
  mutable std::once_flag found_;
  mutable std::vector<Source> sources_;
};
}  // namespace f1tenth_sim2d
