#include <gtest/gtest.h>

#include "f1tenth_sim2d/loaders.h"
#include "temp_folder.h"

namespace f1tenth_sim2d
{
namespace
{
/// A world is read in parts, the models that it includes each on its own, unless a <frame> ties it together: then
/// libsdformat reads it in one piece. Both have to give the same.
class WorldInParts : public testing::Test
{
protected:
  WorldInParts()
  {
    const auto add_model = [this](const std::string & name, const std::string & inside) {
      folder.write("models/" + name + "/model.config", "<model><sdf version='1.5'>model.sdf</sdf></model>");
      folder.write("models/" + name + "/model.sdf", "<sdf version='1.5'>" + inside + "</sdf>");
    };
    add_model(
      "block",
      "<model name='block'><pose>1 2 3 0 0 0.5</pose><link name='a'><pose>0 0 1 0 0 0</pose><inertial><mass>3</mass>"
      "</inertial><collision name='c'><geometry><box><size>1 2 3</size></box></geometry><surface><friction><ode>"
      "<mu>0.3</mu></ode></friction></surface></collision><visual name='v'><geometry><box><size>1 1 1</size></box>"
      "</geometry></visual></link><link name='b'/><joint name='hinge' type='revolute'><parent>a</parent>"
      "<child>b</child><axis><xyz>0 0 1</xyz></axis></joint></model>");
    add_model("sun", "<light name='sun' type='directional'><direction>0 0 -1</direction></light>");
    folder.write("models/block/wedge.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
    add_model(
      "wedge",
      "<model name='wedge'><static>1</static><link name='l'><collision name='c'><geometry><mesh>"
      "<uri>../block/wedge.obj</uri></mesh></geometry></collision></link></model>");
  }

  WorldDescription load(const std::string & inside) const
  {
    return loadWorld(folder.write("x.world", "<sdf version='1.7'><world name='w'>" + inside + "</world></sdf>"));
  }

  void expectSame(const std::string & inside) const
  {
    const WorldDescription parts = load(inside);
    const WorldDescription whole = load(inside + "<frame name='tie'/>");
    EXPECT_EQ(parts.warnings, whole.warnings);
    EXPECT_EQ(parts.name, whole.name);
    EXPECT_EQ(parts.gravity, whole.gravity);
    ASSERT_EQ(parts.models.size(), whole.models.size());
    for (std::size_t i = 0; i < parts.models.size(); ++i) {
      expectSame(parts.models[i], whole.models[i]);
    }
  }

  static void expectSame(const ModelDescription & a, const ModelDescription & b)
  {
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.pose, b.pose) << a.name;
    EXPECT_EQ(a.is_static, b.is_static) << a.name;
    EXPECT_EQ(a.mass, b.mass) << a.name;
    EXPECT_EQ(a.inertia_zz, b.inertia_zz) << a.name;
    ASSERT_EQ(a.solids.size(), b.solids.size()) << a.name;
    for (std::size_t i = 0; i < a.solids.size(); ++i) {
      EXPECT_EQ(a.solids[i].name, b.solids[i].name);
      EXPECT_EQ(a.solids[i].pose, b.solids[i].pose) << a.solids[i].name;
      EXPECT_EQ(a.solids[i].mu, b.solids[i].mu) << a.solids[i].name;
      EXPECT_EQ(a.solids[i].shape.index(), b.solids[i].shape.index()) << a.solids[i].name;
    }
  }

  TempFolder folder;
  const std::string kInline =
    "<model name='own'><link name='l'><collision name='c'><geometry><sphere><radius>1</radius>"
    "</sphere></geometry></collision></link></model>";
};

TEST_F(WorldInParts, IsTheSameAsInOnePiece)
{
  expectSame(
    "<include><uri>model://sun</uri></include><include><uri>model://block</uri></include>" + kInline +
    "<include><uri>model://block</uri><name>second</name><pose>4 5 6 0 0 1</pose><static>true</static></include>"
    "<include><uri>model://wedge</uri></include><light name='lamp' type='point'/><gravity>0 0 -3</gravity>");
}

TEST_F(WorldInParts, IsTheSameWithSensorsPluginsAndState)
{
  expectSame(
    "<model name='m'><link name='l'><sensor name='s' type='altimeter'/></link><plugin name='p' filename='libp.so'>"
    "<light>kept</light></plugin></model>" +
    kInline + "<state world_name='w'><model name='own'><pose>7 8 9 0 0 0</pose></model></state>");
}

TEST_F(WorldInParts, IsTheSameWithANestedModelAndARelativePose)
{
  expectSame(
    "<model name='m'><link name='l'/><frame name='f'><pose>1 0 0 0 0 0</pose></frame><model name='n'>"
    "<pose relative_to='f'>0 1 0 0 0 0</pose><link "
    "name='k'/></model><include><uri>model://block</uri></include></model>");
}

TEST_F(WorldInParts, LeavesWhatIsTiedToOthersToLibsdformat)
{
  const WorldDescription world = load(
    kInline +
    "<include><uri>model://block</uri><pose relative_to='own'>1 0 0 0 0 0</pose></include>"
    "<model name='after'><pose relative_to='block'>0 1 0 0 0 0</pose><link name='l'/></model>");
  ASSERT_EQ(world.models.size(), 3u);
  EXPECT_NEAR(world.models[2].pose.position.x(), 1.0, 1e-12);
  EXPECT_NEAR(world.models[2].pose.position.y(), 1.0, 1e-12);
}

TEST_F(WorldInParts, RefusesTwoModelsOfOneName)
{
  const std::string include = "<include><uri>model://block</uri></include>";
  EXPECT_NE(loadErrorOf([&] { load(include + include); }), "nothing thrown");
}
}  // namespace
}  // namespace f1tenth_sim2d
