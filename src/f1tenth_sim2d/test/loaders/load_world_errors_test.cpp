#include <gtest/gtest.h>

#include "f1tenth_sim2d/loaders.h"
#include "temp_folder.h"

namespace f1tenth_sim2d
{
namespace
{
struct BadWorld
{
  const char * name;
  std::string text;
  std::string message;
};

void PrintTo(const BadWorld & bad, std::ostream * out)
{
  *out << bad.name;
}

std::string oneWorld(const std::string & inside)
{
  return "<?xml version='1.0'?>\n<sdf version='1.6'>\n<world name='w'>" + inside + "</world></sdf>";
}

std::string collision(const std::string & geometry)
{
  return oneWorld(
    "<model name='m'><link name='l'><collision name='c'><geometry>" + geometry +
    "</geometry></collision></link></model>");
}

std::string surface(const std::string & inside)
{
  return oneWorld(
    "<model name='m'><link name='l'><collision name='c'><geometry><sphere><radius>1</radius></sphere></geometry>"
    "<surface>" +
    inside + "</surface></collision></link></model>");
}

const std::string kGeometry = "test.world: world[w]/model[m]/link[l]/collision[c]/geometry";
const std::string kUnsupported =
  ": is not supported as a collision; allowed are <box>, <cylinder>, <sphere>, <polyline>, <plane> and <mesh>";

const std::vector<BadWorld> kBadWorlds{
  {"EmptyFile", "", "test.world: malformed XML: EMPTY_DOCUMENT"},
  {"NotXml", "hello", "test.world: line 1: malformed XML: PARSING_TEXT"},
  {"MismatchedTags", "<sdf version='1.6'>\n<world name='w'>\n<model name='m'>\n</world></sdf>",
   "test.world: line 3: malformed XML: MISMATCHED_ELEMENT, XMLElement name=model"},
  {"VersionThatIsNoNumber", "<sdf version='a.b'><world name='w'/></sdf>",
   "test.world: a library that reads it gives up: stoi"},
  {"NewerVersion", "<sdf version='9.9'><world name='w'/></sdf>",
   "test.world: Unable to convert from SDF version 9.9 to 1.9"},
  {"NoWorld", "<sdf version='1.6'><model name='m'><link name='l'/></model></sdf>",
   "test.world: holds 0 worlds, allowed is one <world>"},
  {"TwoWorlds", "<sdf version='1.6'><world name='a'/><world name='b'/></sdf>",
   "test.world: holds 2 worlds, allowed is one <world>"},
  {"ModelWithoutName", oneWorld("<model><link name='l'/></model>"),
   "test.world: world[w]/model: Required attribute[name] in element[model] is not specified in SDF"},
  {"ModelWithoutLink", oneWorld("<model name='m'/>"),
   "test.world: world[w]/model[m]: A model must have at least one link"},
  {"ModelNameTwice", oneWorld("<model name='m'><link name='l'/></model><model name='m'><link name='l'/></model>"),
   "test.world: world[w]/model[m]: this name is taken; names are unique among the elements of one parent"},
  {"LinkNameTwice", oneWorld("<model name='m'><link name='l'/><link name='l'/></model>"),
   "test.world: world[w]/model[m]/link[l]: this name is taken; names are unique among the elements of one parent"},
  {"UnknownUri", oneWorld("<include><uri>model://nowhere</uri></include>"),
   "test.world: world[w]/include[0]/uri: Unable to find uri[model://nowhere]; searched: /no/models, ."},
  {"Population", oneWorld("<population name='p'><model name='m'><link name='l'/></model></population>"),
   "test.world: world[w]/population[p]: is not supported; write its models one by one"},
  {"UnknownFrame", oneWorld("<model name='m'><link name='l'><pose frame='nix'>0 0 0 0 0 0</pose></link></model>"),
   "test.world: relative_to name[nix] specified by link with name[l] does not match a nested model, link, joint, or "
   "frame name in model with name[m]"},
  {"PoseOfThreeNumbers", oneWorld("<model name='m'><pose>1 2 3</pose><link name='l'/></model>"),
   "test.world: world[w]/model[m]/pose: The value for //pose[@rotation_format='euler_rpy'] must have 6 values, but 3 "
   "were found instead in '1 2 3'"},
  {"PoseNotFinite", oneWorld("<model name='m'><pose>nan 0 0 0 0 0</pose><link name='l'/></model>"),
   "test.world: world[w]/model[m]/pose: Pose values must be finite"},
  {"PoseNotANumber", oneWorld("<model name='m'><pose>1 2 x 0 0 0</pose><link name='l'/></model>"),
   "test.world: world[w]/model[m]/pose: Invalid argument. Unable to set value [1 2 x 0 0 0] for key [pose]"},
  {"NegativeMass", oneWorld("<model name='m'><link name='l'><inertial><mass>-1</mass></inertial></link></model>"),
   "test.world: A link named l has invalid inertia"},
  {"NoGeometry", oneWorld("<model name='m'><link name='l'><collision name='c'/></link></model>"),
   kGeometry + ": is empty; allowed are <box>, <cylinder>, <sphere>, <polyline>, <plane> and <mesh>"},
  {"EmptyGeometry", collision(""),
   kGeometry + ": is empty; allowed are <box>, <cylinder>, <sphere>, <polyline>, <plane> and <mesh>"},
  {"MeshNotFound", collision("<mesh><uri>model://m/mesh.dae</uri></mesh>"),
   kGeometry + "/mesh: <uri> is model://m/mesh.dae, which is not found; searched: /no/models, ."},
  {"MeshWithoutUri", collision("<mesh/>"), kGeometry + "/mesh: has no <uri>"},
  {"MeshThatIsAFolder", collision("<mesh><uri>file:///tmp</uri></mesh>"),
   kGeometry + "/mesh: <uri> is file:///tmp, but /tmp is not a file"},
  {"MeshOfAnotherFormat", collision("<mesh><uri>test.world</uri></mesh>"),
   kGeometry + "/mesh: <uri> is test.world, allowed are files that end with .dae, .stl or .obj"},
  {"Heightmap", collision("<heightmap><uri>h.png</uri></heightmap>"), kGeometry + "/heightmap" + kUnsupported},
  {"Capsule", collision("<capsule><radius>1</radius><length>1</length></capsule>"),
   kGeometry + "/capsule" + kUnsupported},
  {"BoxWithoutSize", collision("<box/>"), kGeometry + "/box: has no <size>"},
  {"NegativeSize", collision("<box><size>1 -1 1</size></box>"),
   kGeometry + "/box: <size> is -1, allowed are finite numbers greater than 0"},
  {"ZeroRadius", collision("<cylinder><radius>0</radius><length>1</length></cylinder>"),
   kGeometry + "/cylinder: <radius> is 0, allowed are finite numbers greater than 0"},
  {"InfiniteLength", collision("<cylinder><radius>1</radius><length>inf</length></cylinder>"),
   kGeometry + "/cylinder: <length> is inf, allowed are finite numbers greater than 0"},
  {"RadiusNan", collision("<sphere><radius>nan</radius></sphere>"),
   kGeometry + "/sphere: <radius> is nan, allowed are finite numbers greater than 0"},
  {"RadiusNotANumber", collision("<sphere><radius>abc</radius></sphere>"),
   kGeometry + "/sphere/radius: Invalid argument. Unable to set value [abc ] for key[radius]"},
  {"EndlessCylinder", collision("<cylinder><radius>1e300</radius><length>1</length></cylinder>"),
   kGeometry + "/cylinder: <radius> is 1e+300, allowed is at most 100000 m"},
  {"ModelOutOfThisWorld", oneWorld("<model name='m'><pose>1e200 0 0 0 0 0</pose><link name='l'/></model>"),
   "test.world: world[w]/model[m]: is not within 100000 m of the origin"},
  {"CollisionOutOfThisWorld",
   oneWorld("<model name='m'><link name='l'><collision name='c'><pose>0 -1e9 0 0 0 0</pose><geometry><sphere><radius>1"
            "</radius></sphere></geometry></collision></link></model>"),
   "test.world: world[w]/model[m]/link[l]/collision[c]: is not within 100000 m of the origin"},
  {"MassOutOfThisWorld",
   oneWorld("<model name='m'><link name='l'><inertial><pose>1e9 0 0 0 0 0</pose></inertial></link></model>"),
   "test.world: world[w]/model[m]: is not within 100000 m of the origin"},
  {"PolylineOutOfThisWorld",
   collision("<polyline><point>0 0</point><point>1e9 0</point><point>0 1</point><height>1</height></polyline>"),
   kGeometry + "/polyline: is not within 100000 m of the origin"},
  {"NameOfAHundredThousandLetters",
   oneWorld("<model name='" + std::string(100000, 'm') + "'><pose>1 2 3</pose><link name='l'/></model>"),
   "test.world: world[w]/model[" + std::string(100000, 'm') +
     "]/pose: The value for //pose[@rotation_format='euler_rpy'] must have 6 values, but 3 were found instead in "
     "'1 2 3'"},
  {"PoseOfAHundredThousandBlanks",
   oneWorld("<model name='m'><pose>1" + std::string(100000, ' ') + "x</pose><link name='l'/></model>"),
   "test.world: world[w]/model[m]/pose: Invalid argument. Unable to set value [1 x] for key [pose]"},
  {"PlaneWithoutDirection", collision("<plane><normal>0 0 0</normal><size>1 1</size></plane>"),
   kGeometry + "/plane: <normal> has no direction"},
  {"PolylineOfTwoPoints", collision("<polyline><point>0 0</point><point>1 0</point><height>1</height></polyline>"),
   kGeometry + "/polyline: is not an outline: allowed are at least three points whose edges enclose an area and do "
               "not cross"},
  {"PolylineThatCrossesItself",
   collision("<polyline><point>0 0</point><point>2 2</point><point>2 0</point><point>0 1</point><height>1</height>"
             "</polyline>"),
   kGeometry + "/polyline: is not an outline: allowed are at least three points whose edges enclose an area and do "
               "not cross"},
  {"PolylineNotFinite",
   collision("<polyline><point>0 0</point><point>nan 2</point><point>2 0</point><height>1</height></polyline>"),
   kGeometry + "/polyline/point: Unknown error. Unable to set value [nan 2 ] for key[point]"},
  {"PolylineWithAHole",
   collision("<polyline><point>0 0</point><point>3 0</point><point>0 3</point><height>1</height></polyline>"
             "<polyline><point>1 1</point><point>1.2 1</point><point>1 1.2</point><height>1</height></polyline>"),
   kGeometry + "/polyline: has a second <polyline> beside it; allowed is one, holes are not supported"},
  {"NegativeFriction", surface("<friction><ode><mu>-1</mu></ode></friction>"),
   "test.world: world[w]/model[m]/link[l]/collision[c]/surface/friction/ode/mu: The value [-1] is less than the "
   "minimum allowed value of [0] for key [mu]"},
  {"FrictionNan", surface("<friction><ode><mu>nan</mu></ode></friction>"),
   "test.world: world[w]/model[m]/link[l]/collision[c]/surface/friction/ode: <mu> is nan, allowed are finite numbers "
   "from 0"},
  {"BounceNan", surface("<bounce><restitution_coefficient>nan</restitution_coefficient></bounce>"),
   "test.world: world[w]/model[m]/link[l]/collision[c]/surface/bounce: <restitution_coefficient> is nan, allowed are "
   "finite numbers from 0"},
};

class LoadWorldErrors : public testing::TestWithParam<BadWorld>
{
};

TEST_P(LoadWorldErrors, NameFilePlaceAndReason)
{
  const TempFolder folder;
  const std::string path = folder.write("test.world", GetParam().text);
  const std::string message = withoutFolder(loadErrorOf([&] { loadWorld(path, {{"/no/models"}, {}}); }), folder);
  // The folders beside the world differ from run to run.
  EXPECT_EQ(message.substr(0, message.find(folder.path())), GetParam().message.substr(0, message.find(folder.path())));
}

INSTANTIATE_TEST_SUITE_P(
  BadWorlds, LoadWorldErrors, testing::ValuesIn(kBadWorlds),
  [](const testing::TestParamInfo<BadWorld> & bad) { return bad.param.name; });

TEST(LoadWorldErrorsOfFiles, MissingFile)
{
  EXPECT_EQ(loadErrorOf([] { loadWorld("/nowhere/x.world"); }), "/nowhere/x.world: no such file");
}

TEST(LoadWorldErrorsOfFiles, Folder)
{
  const TempFolder folder;
  EXPECT_EQ(loadErrorOf([&] { loadWorld(folder.path()); }), folder.path() + ": is not a file");
}

/// A world that includes a model whose files are wrong.
class LoadWorldErrorsOfIncludes : public testing::Test
{
protected:
  std::string load() const
  {
    const std::string path = folder.write("test.world", oneWorld("<include><uri>model://thing</uri></include>"));
    return withoutFolder(loadErrorOf([&] { loadWorld(path); }), folder);
  }

  TempFolder folder;
  const std::string kConfig = "<model><name>thing</name><sdf version='1.6'>model.sdf</sdf></model>";
};

TEST_F(LoadWorldErrorsOfIncludes, UnknownUriNamesEveryFolderSearched)
{
  const std::string path = folder.write("worlds/test.world", oneWorld("<include><uri>model://thing</uri></include>"));
  const std::string root = folder.path();
  EXPECT_EQ(
    loadErrorOf([&] {
      loadWorld(path, {{"/a", "/b"}, {"/c"}});
    }),
    path + ": world[w]/include[0]/uri: Unable to find uri[model://thing]; searched: /a, /b, " + root + "/worlds, " +
      root + "/worlds/models, " + root + "/models, and the ROS packages below /c");
}

TEST_F(LoadWorldErrorsOfIncludes, FolderWithoutModelConfig)
{
  folder.write("thing/readme.txt", "");
  EXPECT_EQ(
    load().find("test.world: world[w]/include[0]/uri: Unable to resolve uri[model://thing] to model path [thing] since "
                "it does not contain a model.config file; searched: "),
    0u);
}

TEST_F(LoadWorldErrorsOfIncludes, ModelThatIncludesItselfOverAnother)
{
  const auto includes = [](const std::string & name) {
    return "<sdf version='1.6'><model name='m'><include><uri>model://" + name + "</uri></include></model></sdf>";
  };
  folder.write("thing/model.config", kConfig);
  folder.write("thing/model.sdf", includes("other"));
  folder.write("other/model.config", kConfig);
  folder.write("other/model.sdf", includes("thing"));
  EXPECT_EQ(load(), "test.world: other/model.sdf includes thing/model.sdf, which includes it: that never ends");
}

TEST_F(LoadWorldErrorsOfIncludes, MissingModelFile)
{
  folder.write("thing/model.config", kConfig);
  EXPECT_EQ(load(), "test.world: world[w]/include[0]/uri: Error finding file [thing/model.sdf]");
}

TEST_F(LoadWorldErrorsOfIncludes, MalformedModelFileIsNamed)
{
  folder.write("thing/model.config", kConfig);
  folder.write("thing/model.sdf", "<sdf version='1.6'>\n<model name='thing'>\n<link></model></sdf>");
  EXPECT_EQ(load(), "test.world: thing/model.sdf, line 3: malformed XML: MISMATCHED_ELEMENT, XMLElement name=link");
}
}  // namespace
}  // namespace f1tenth_sim2d
