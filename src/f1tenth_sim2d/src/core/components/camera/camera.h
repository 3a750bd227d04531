#pragma once

#include <memory>
#include <string>
#include <vector>

#include "f1tenth_sim2d/component.h"
#include "render/camera.h"
#include "render/lens.h"

namespace f1tenth_sim2d
{
/// One or several eyes that look at the same time. Draws nothing until somebody looks.
class Camera : public CopiedComponent<Camera>
{
public:
  struct Eye
  {
    std::string name;                    ///< unique in the camera
    Pose3 pose;                          ///< in the frame of the car: it looks along x, z is up
    Pinhole pinhole;                     ///< to which its pictures belong, but for the lens
    std::shared_ptr<const Lens> lens{};  ///< null: none
    double noise_stddev{0.0};            ///< of each colour, as a share of the greatest
    std::string format{"rgb8"};          ///< as sensor_msgs/Image calls it
    double baseline{0.0};                ///< m, from the left eye of a pair to this one: hackBaseline
    Pinhole calibration{};               ///< what camera_info says of it, which a plug-in may change
    Distortion distortion{};             ///< likewise

    /// Where a pixel looks, as Pinhole::ray; not a number in the black border of a lens.
    Vec3 ray(std::size_t pixel) const
    {
      const auto width = static_cast<std::size_t>(pinhole.width);
      return lens ? lens->ray(pixel)
                  : pinhole.ray(static_cast<double>(pixel % width), static_cast<double>(pixel / width));
    }

    // Where it is published; empty: nowhere.
    std::string image_topic{};
    std::string info_topic{};
    std::string depth_topic{};
    std::string depth_info_topic{};
    std::string points_topic{};
    std::string trigger_topic{};       ///< of the messages that ask for a picture; empty: it looks at its rate
    bool depth_in_millimetres{false};  ///< as whole numbers, else in metres
    double points_nearest{0.0};        ///< m
    double points_farthest{0.0};       ///< m
  };

  Camera(Mount mount, std::vector<Eye> eyes) : CopiedComponent(std::move(mount)), eyes_(std::move(eyes)) {}

  const std::vector<Eye> & eyes() const { return eyes_; }
  /// @throws Error naming those that there are; an empty name means the first
  const Eye & eye(const std::string & name) const;

  /// What eyes see now, drawn on two threads. The noise depends on seed, car, eye and time only.
  /// @param eyes      of this camera
  /// @param pictures  as many
  void look(
    const Simulation & simulation, CarId car, const std::vector<const Eye *> & eyes,
    const std::vector<Picture *> & pictures) const;

private:
  void addNoise(const Simulation & simulation, CarId car, const Eye & eye, Picture & picture) const;

  std::vector<Eye> eyes_;
};
}  // namespace f1tenth_sim2d
