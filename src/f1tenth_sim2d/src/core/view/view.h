#pragma once

#include <memory>

#include "core/view/world_look.h"
#include "f1tenth_sim2d/simulation.h"
#include "render/renderer.h"

namespace f1tenth_sim2d
{
/// Draws what cameras of a simulation see, with all that moves where it is now.
class View
{
public:
  /// @param look  of the world of the simulation
  /// @param pose  of the camera in the frame of the car
  void draw(
    const Simulation & simulation, const std::shared_ptr<const WorldLook> & look, CarId car, const Pinhole & camera,
    const Pose3 & pose, Picture & picture);

private:
  void placeModels(const Simulation & simulation);
  void placeCar(const Simulation & simulation, CarId car);
  void place(const Surface & surface, const Transform & pose) { scene_.surfaces.push_back({surface, pose, true}); }

  std::shared_ptr<const WorldLook> look_;  ///< whose fixed surfaces are at the beginning of the scene
  Scene scene_;
  Renderer renderer_;
};
}  // namespace f1tenth_sim2d
