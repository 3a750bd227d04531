#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "f1tenth_sim2d/loaders.h"
#include "f1tenth_sim2d/section.h"
#include "temp_folder.h"

namespace f1tenth_sim2d
{
namespace
{
/// Worlds made by others, for Gazebo.
class WorldsOfOthers : public testing::Test
{
protected:
  void SetUp() override
  {
    const char * const given = std::getenv("F1TENTH_DATA");
    data = given ? given : F1TENTH_DEFAULT_DATA;
    if (!std::filesystem::exists(data)) {
      GTEST_SKIP() << "there is no folder " << data << "; F1TENTH_DATA names another one";
    }
  }

  WorldDescription load(const std::string & name) const
  {
    return loadWorld(data + "/worlds/" + name, {data + "/gazebo_models"});
  }

  std::string data;
};

TEST_F(WorldsOfOthers, BarnWorldsAreFieldsOfCylinders)
{
  const std::pair<const char *, std::size_t> worlds[] = {
    {"barn_world_0.world", 209}, {"barn_world_150.world", 292}, {"barn_world_299.world", 277}};
  for (const auto & [name, cylinders] : worlds) {
    const WorldDescription world = load(name);
    std::size_t circles = 0;
    for (const ModelDescription & model : world.models) {
      for (const Solid & solid : model.solids) {
        circles += sectionAt(solid, model.pose * solid.pose, 0.16).circles.size();
      }
    }
    EXPECT_EQ(circles, cylinders) << name;
    EXPECT_EQ(
      world.warnings, std::vector<std::string>{"world[default]/light[sun]: <light> is left out: a lidar needs none"});
  }
}

TEST_F(WorldsOfOthers, TunnelOfTheRacecarIncludesItsModelAndTheSun)
{
  const WorldDescription world = load("racecar_tunnel.world");
  ASSERT_EQ(world.models.size(), 2u);
  EXPECT_FALSE(world.models[1].solids.empty());
}

TEST_F(WorldsOfOthers, ConesAreMeshesAndRefused)
{
  EXPECT_NE(
    loadErrorOf([this] { load("racecar_cones.world"); }).find("/geometry/mesh: is not supported as a collision"),
    std::string::npos);
}

TEST_F(WorldsOfOthers, FurnitureOfBoxesAndCylindersLoads)
{
  const TempFolder folder;
  std::string includes;
  for (const char * const model : {"bookshelf", "cabinet", "ground_plane", "sun", "table", "wooden_case"}) {
    includes += std::string("<include><uri>model://") + model + "</uri></include>";
  }
  const std::string file =
    folder.write("furniture.world", "<sdf version='1.6'><world name='w'>" + includes + "</world></sdf>");
  EXPECT_EQ(loadWorld(file, {data + "/gazebo_models"}).models.size(), 5u);
}
}  // namespace
}  // namespace f1tenth_sim2d
