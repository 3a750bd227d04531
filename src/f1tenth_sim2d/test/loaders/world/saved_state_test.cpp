// What the <state> of a world that Gazebo saved may not make of its models.
#include <gtest/gtest.h>

#include "f1tenth_sim2d/loaders.h"
#include "temp_folder.h"

namespace f1tenth_sim2d
{
namespace
{
const std::string kPlace = "test.world: world[w]/state/model[m]";

class SavedState : public testing::Test
{
protected:
  /// What is said of a model m with a link l of one shape and the state of m.
  std::string error(const std::string & shape, const std::string & state) const
  {
    const std::string text =
      "<sdf version='1.6'><world name='w'><model name='m'><static>1</static><link name='l'>"
      "<collision name='c'><geometry>" +
      shape + "</geometry></collision></link></model><state world_name='w'><model name='m'>" + state +
      "</model></state></world></sdf>";
    const std::string path = folder_.write("test.world", text);
    return withoutFolder(loadErrorOf([&path] { loadWorld(path); }), folder_);
  }

  TempFolder folder_;
};

TEST_F(SavedState, RefusesAScaleThatMakesAShapeTooLarge)
{
  const std::string too_long = kPlace + "/scale: a length that it makes is 1e+06, allowed is at most 100000 m";
  const std::string scale = "<scale>1e6 1e6 1e6</scale>";
  EXPECT_EQ(error("<box><size>1 1 1</size></box>", scale), too_long);
  EXPECT_EQ(error("<sphere><radius>1</radius></sphere>", scale), too_long);
  EXPECT_EQ(error("<cylinder><radius>1</radius><length>1</length></cylinder>", scale), too_long);
  EXPECT_EQ(
    error("<cylinder><radius>1</radius><length>1</length></cylinder>", "<scale>1 1 1e300</scale>"),
    kPlace + "/scale: a length that it makes is 1e+300, allowed is at most 100000 m");
  EXPECT_EQ(error("<box><size>1 1 1</size></box>", "<scale>1e5 1 1</scale>"), "nothing thrown");
}

TEST_F(SavedState, RefusesAScaleThatMakesAShapeVanish)
{
  EXPECT_EQ(
    error("<box><size>1e-10 1 1</size></box>", "<scale>1e-320 1 1</scale>"),
    kPlace + "/scale: a length that it makes is 0, allowed are finite numbers greater than 0");
}

TEST_F(SavedState, RefusesAScaleThatMovesVerticesOutOfThisWorld)
{
  folder_.write("slope.obj", "v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n");
  EXPECT_EQ(
    error("<mesh><uri>slope.obj</uri></mesh>", "<scale>1e12 1e12 1</scale>"),
    kPlace + "/scale: is not within 100000 m of the origin");
}

TEST_F(SavedState, RefusesALinkOutOfThisWorld)
{
  EXPECT_EQ(
    error("<box><size>1 1 1</size></box>", "<link name='l'><pose>1e30 0 0 0 0 0</pose></link>"),
    kPlace + "/link[l]: is not within 100000 m of the origin");
}
}  // namespace
}  // namespace f1tenth_sim2d
