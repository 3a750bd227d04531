#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "f1tenth_sim2d/loaders.h"
#include "f1tenth_sim2d/section.h"
#include "polygons.h"
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
    return loadWorld(data + "/worlds/" + name, {{data + "/gazebo_models"}, {}});
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
  }
}

TEST_F(WorldsOfOthers, TunnelOfTheRacecarIncludesItsModelAndTheSun)
{
  const WorldDescription world = load("racecar_tunnel.world");
  ASSERT_EQ(world.models.size(), 2u);
  EXPECT_FALSE(world.models[1].solids.empty());
}

TEST_F(WorldsOfOthers, ConesOfTheRacecarAreMeshes)
{
  const WorldDescription world = load("racecar_cones.world");
  ASSERT_EQ(world.models.size(), 6u);
  const Solid & cone = world.models[1].solids.at(0);
  EXPECT_EQ(world.models[1].name, "cone_1");
  EXPECT_FALSE(world.models[1].is_static);
  const Section low = sectionAt(cone, world.models[1].pose * cone.pose, 0.01);
  const Section high = sectionAt(cone, world.models[1].pose * cone.pose, 0.15);
  EXPECT_GT(areaOf(low.outlines), 2.0 * areaOf(high.outlines));
  EXPECT_GT(areaOf(high.outlines), 0.0);
  EXPECT_EQ(std::get<Mesh>(cone.shape).surface, std::get<Mesh>(world.models[2].solids.at(0).shape).surface);
}

TEST_F(WorldsOfOthers, EveryWorldLoads)
{
  std::size_t count = 0;
  for (const auto & entry : std::filesystem::directory_iterator(data + "/worlds")) {
    if (entry.path().extension() == ".world") {
      const WorldDescription world = load(entry.path().filename().string());
      EXPECT_FALSE(world.models.empty()) << world.file;
      EXPECT_TRUE(world.warnings.empty()) << world.file << ": " << world.warnings.front();
      ++count;
    }
  }
  EXPECT_EQ(count, 5u);
}

TEST_F(WorldsOfOthers, EveryModelOfTheGazeboDatabaseLoads)
{
  const TempFolder folder;
  for (const auto & entry : std::filesystem::directory_iterator(data + "/gazebo_models")) {
    const std::string name = entry.path().filename().string();
    SCOPED_TRACE(name);
    const WorldDescription world = loadWorld(
      folder.write(
        name + ".world",
        "<sdf version='1.6'><world name='w'><include><uri>model://" + name + "</uri></include></world></sdf>"),
      {{data + "/gazebo_models"}, {}});
    EXPECT_EQ(world.models.empty(), name == "sun");
    for (const ModelDescription & model : world.models) {
      EXPECT_FALSE(model.solids.empty()) << model.name;
    }
    for (const std::string & warning : world.warnings) {
      EXPECT_NE(warning.find(": <joint> does not move: a model is one rigid body"), std::string::npos) << warning;
    }
  }
}
}  // namespace
}  // namespace f1tenth_sim2d
