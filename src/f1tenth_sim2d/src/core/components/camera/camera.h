#pragma once

#include <array>
#include <string>
#include <vector>

#include "f1tenth_sim2d/component.h"
#include "render/camera.h"

namespace f1tenth_sim2d
{
/// One or several pinhole cameras that look at the same time. Draws nothing until somebody looks.
class Camera : public CopiedComponent<Camera>
{
public:
  struct Eye
  {
    std::string name;  ///< unique in the camera
    Pose3 pose;        ///< in the frame of the car: it looks along x, z is up
    Pinhole pinhole;
    double noise_stddev{0.0};            ///< of each colour, as a share of the greatest
    std::string format{"rgb8"};          ///< as sensor_msgs/Image calls it
    double baseline{0.0};                ///< m, from the left eye of a pair to this one: hackBaseline
    Pinhole calibration{};               ///< what camera_info says of it, which a plug-in may change
    std::array<double, 5> distortion{};  ///< likewise, k1, k2, t1, t2, k3: told, not drawn

    // Where it is published; empty: nowhere.
    std::string image_topic{};
    std::string info_topic{};
    std::string depth_topic{};
    std::string depth_info_topic{};
    std::string points_topic{};
    bool depth_in_millimetres{false};  ///< as whole numbers, else in metres
    double points_nearest{0.0};        ///< m
    double points_farthest{0.0};       ///< m
  };

  Camera(Mount mount, std::vector<Eye> eyes) : CopiedComponent(std::move(mount)), eyes_(std::move(eyes)) {}

  const std::vector<Eye> & eyes() const { return eyes_; }
  /// @throws Error naming those that there are; an empty name means the first
  const Eye & eye(const std::string & name) const;

  /// What an eye sees now. The noise depends on seed, car, eye and time only.
  /// @param eye  of this camera
  void look(const Simulation & simulation, CarId car, const Eye & eye, Picture & picture) const;

private:
  std::vector<Eye> eyes_;
};
}  // namespace f1tenth_sim2d
