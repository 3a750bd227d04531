#include "core/components/camera/camera.h"

#include <gtest/gtest.h>

#include "render/solid_mesh.h"
#include "sample_world.h"

namespace f1tenth_sim2d::test
{
namespace
{
/// A red box.
class BoxLook : public Look
{
  Appearance read() const override
  {
    Surface surface;
    surface.mesh = meshOf(Box{{1, 1, 1}}, {});
    surface.material.diffuse = {1.0F, 0.0F, 0.0F};
    return {{surface}, ""};
  }
};

Camera::Eye eyeAt(const std::string & name, double y)
{
  Camera::Eye eye;
  eye.name = name;
  eye.pose = Pose3(0.0, y, 0.3, 0.0, 0.0, 0.0);
  eye.pinhole = {64, 48, 40.0, 40.0, 31.5, 23.5};
  return eye;
}

WorldDescription boxes()
{
  WorldDescription described = world();
  for (const double y : {-1.0, 0.5}) {
    ModelDescription model = movableBox("box" + std::to_string(y), 1.0, 3.0, y);
    model.visuals.push_back({Pose3(0, 0, 0.5, 0, 0, 0), {}, std::make_shared<BoxLook>()});
    described.models.push_back(model);
  }
  return described;
}
}  // namespace

TEST(Camera, EyesThatLookTogetherSeeTheSameBitsAsOneAfterAnother)
{
  CarDescription description = car("robot1");
  const std::vector<Camera::Eye> eyes{eyeAt("left", 0.1), eyeAt("middle", 0.0), eyeAt("right", -0.1)};
  const Camera camera({"camera", "", "", Pose3(), 0.0}, eyes);
  Simulation simulation(boxes());
  simulation.addCar(description, {}, {});
  std::vector<Picture> together(eyes.size());
  std::vector<const Camera::Eye *> looking;
  std::vector<Picture *> pictures;
  for (std::size_t i = 0; i < eyes.size(); ++i) {
    looking.push_back(&camera.eyes()[i]);
    pictures.push_back(&together[i]);
  }
  for (int round = 0; round < 20; ++round) {
    drive(simulation, kRobot1, {0.5, 0.1}, 0.1);
    camera.look(simulation, kRobot1, looking, pictures);
    for (std::size_t i = 0; i < eyes.size(); ++i) {
      Picture alone;
      camera.look(simulation, kRobot1, {looking[i]}, {&alone});
      EXPECT_EQ(together[i].colours, alone.colours);
      EXPECT_EQ(together[i].depths, alone.depths);
    }
  }
  EXPECT_NE(together[0].colours, together[2].colours);
}
}  // namespace f1tenth_sim2d::test
