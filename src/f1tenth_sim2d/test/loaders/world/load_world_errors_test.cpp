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
const std::string kEmpty =
  ": is empty; allowed are <box>, <capsule>, <cylinder>, <ellipsoid>, <sphere>, <polyline>, <plane> and <mesh>";
const std::string kUnsupported =
  ": is not supported as a collision; allowed are <box>, <capsule>, <cylinder>, <ellipsoid>, <sphere>, <polyline>, "
  "<plane> "
  "and <mesh>";

const std::vector<BadWorld> kBadWorlds{
  {"EmptyFile", "", "test.world: malformed XML: EMPTY_DOCUMENT"},
  {"NotXml", "hello", "test.world: line 1: malformed XML: PARSING_TEXT"},
  {"MismatchedTags", "<sdf version='1.6'>\n<world name='w'>\n<model name='m'>\n</world></sdf>",
   "test.world: line 3: malformed XML: MISMATCHED_ELEMENT, XMLElement name=model"},
  {"VersionThatIsNoNumber", "<sdf version='a.b'><world name='w'/></sdf>",
   "test.world: sdf: version is 'a.b', allowed are 1.3 to 1.9"},
  {"NewerVersion", "<sdf version='9.9'><world name='w'/></sdf>",
   "test.world: sdf: version is '9.9', allowed are 1.3 to 1.9"},
  {"NoWorld", "<sdf version='1.6'><model name='m'><link name='l'/></model></sdf>",
   "test.world: holds 0 worlds, allowed is one <world>"},
  {"TwoWorlds", "<sdf version='1.6'><world name='a'/><world name='b'/></sdf>",
   "test.world: holds 2 worlds, allowed is one <world>"},
  {"ModelWithoutName", oneWorld("<model><link name='l'/></model>"),
   "test.world: world[w]/model: has no attribute 'name'"},
  {"LinkNameTwice", oneWorld("<model name='m'><link name='l'/><link name='l'/></model>"),
   "test.world: world[w]/model[m]/link[l]: this name is taken; names are unique among the elements of one parent"},
  {"UnknownUri", oneWorld("<include><uri>model://nowhere</uri></include>"),
   "test.world: world[w]/include[0]/uri: Unable to find uri[model://nowhere]; searched: /no/models, ."},
  {"Population", oneWorld("<population name='p'><model name='m'><link name='l'/></model></population>"),
   "test.world: world[w]/population[p]: is not supported; write its models one by one"},
  {"UnknownFrame", oneWorld("<model name='m'><link name='l'><pose frame='nix'>0 0 0 0 0 0</pose></link></model>"),
   "test.world: world[w]/model[m]/link[l]/pose: names the frame 'nix', which is no link, joint, frame or model here"},
  {"PoseOfThreeNumbers", oneWorld("<model name='m'><pose>1 2 3</pose><link name='l'/></model>"),
   "test.world: world[w]/model[m]/pose: is '1 2 3', allowed are six numbers: x y z roll pitch yaw"},
  {"PoseNotFinite", oneWorld("<model name='m'><pose>nan 0 0 0 0 0</pose><link name='l'/></model>"),
   "test.world: world[w]/model[m]/pose: is 'nan 0 0 0 0 0', allowed are finite numbers"},
  {"PoseNotANumber", oneWorld("<model name='m'><pose>1 2 x 0 0 0</pose><link name='l'/></model>"),
   "test.world: world[w]/model[m]/pose: is '1 2 x 0 0 0', which is not all numbers"},
  {"NegativeMass", oneWorld("<model name='m'><link name='l'><inertial><mass>-1</mass></inertial></link></model>"),
   "test.world: world[w]/model[m]: can be pushed, but has a mass (kg) of -1; allowed are finite numbers greater than "
   "0, or "
   "<static>true</static>"},
  {"NoGeometry", oneWorld("<model name='m'><link name='l'><collision name='c'/></link></model>"),
   "test.world: world[w]/model[m]/link[l]/collision[c]: has no <geometry>"},
  {"EmptyGeometry", collision(""), kGeometry + kEmpty},
  {"MeshNotFound", collision("<mesh><uri>model://m/mesh.dae</uri></mesh>"),
   kGeometry + "/mesh: <uri> is model://m/mesh.dae, which is not found; searched: /no/models, ."},
  {"MeshWithoutUri", collision("<mesh/>"), kGeometry + "/mesh: has no <uri>"},
  {"MeshThatIsAFolder", collision("<mesh><uri>file:///tmp</uri></mesh>"),
   kGeometry + "/mesh: <uri> is file:///tmp, but /tmp is not a file"},
  {"MeshOfAnotherFormat", collision("<mesh><uri>test.world</uri></mesh>"),
   kGeometry + "/mesh: <uri> is test.world, allowed are files that end with .dae, .stl or .obj"},
  {"Heightmap", collision("<heightmap><uri>h.png</uri></heightmap>"), kGeometry + "/heightmap" + kUnsupported},
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
   kGeometry + "/sphere: <radius> is 'abc', which is no number"},
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
     "]/pose: is '1 2 3', allowed are six numbers: x y z roll pitch yaw"},
  {"PoseOfAHundredThousandBlanks",
   oneWorld("<model name='m'><pose>1" + std::string(100000, ' ') + "x</pose><link name='l'/></model>"),
   "test.world: world[w]/model[m]/pose: is '1" + std::string(100000, ' ') + "x', which is not all numbers"},
  {"PoseInUnknownDegrees", oneWorld("<model name='m'><pose degrees='yes'>0 0 0 0 0 9</pose><link name='l'/></model>"),
   "test.world: world[w]/model[m]/pose: attribute 'degrees' is 'yes', allowed are true, false, 1 and 0"},
  {"PoseInAnUnknownFormat",
   oneWorld("<model name='m'><pose rotation_format='euler'>0 0 0 0 0 9</pose><link name='l'/></model>"),
   "test.world: world[w]/model[m]/pose: attribute 'rotation_format' is 'euler', allowed are euler_rpy and quat_xyzw"},
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
  {"PolylinesThatLeaveNothing",
   collision("<polyline><point>0 0</point><point>2 0</point><point>0 2</point><height>1</height></polyline>"
             "<polyline><point>0 0</point><point>2 0</point><point>0 2</point><height>1</height></polyline>"),
   kGeometry + ": has <polyline>s that leave nothing: what an even number of them enclose is empty"},
  {"PolylineNotFinite",
   collision("<polyline><point>0 0</point><point>nan 2</point><point>2 0</point><height>1</height></polyline>"),
   kGeometry + "/polyline: is not within 100000 m of the origin"},
  {"FrictionNan", surface("<friction><ode><mu>nan</mu></ode></friction>"),
   "test.world: world[w]/model[m]/link[l]/collision[c]/surface/friction/ode: <mu> is nan, allowed are finite numbers "
   "from 0"},
  {"BounceNan", surface("<bounce><restitution_coefficient>nan</restitution_coefficient></bounce>"),
   "test.world: world[w]/model[m]/link[l]/collision[c]/surface/bounce: <restitution_coefficient> is nan, allowed are "
   "finite numbers from 0"},
  {"GravityUpwards", oneWorld("<gravity>0 0 9.8</gravity>"),
   "test.world: world[w]: z of <gravity> is 9.8, allowed is at most 0: it points downwards"},
  {"ScaleOfAStateIsZero",
   oneWorld("<model name='m'><link name='l'/></model><state><model name='m'><scale>1 -1 1</scale></model></state>"),
   "test.world: world[w]/state/model[m]: <scale> is '1 -1 1', allowed are three finite numbers from 0"},
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
    load(), "test.world: world[w]/include[0]/uri: uri[model://thing] is the folder thing, which holds no model.config");
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
  EXPECT_EQ(
    load(),
    "other/model.sdf: model[m]/include[0]: includes thing/model.sdf, which includes it: that never ends; included by "
    "thing/model.sdf: model[m]/include[0]");
}

TEST_F(LoadWorldErrorsOfIncludes, ModelThatIncludesItselfByAnotherSpelling)
{
  folder.write("thing/model.config", kConfig);
  folder.write(
    "thing/model.sdf",
    "<sdf version='1.6'><model name='m'><include><uri>../thing/model.sdf</uri></include></model></sdf>");
  EXPECT_EQ(
    load(),
    "thing/model.sdf: model[m]/include[0]: includes thing/../thing/model.sdf, which includes it: that never ends; "
    "included by test.world: world[w]/include[0]");
}

TEST_F(LoadWorldErrorsOfIncludes, DocumentThatIsNoSdf)
{
  folder.write("thing/model.config", kConfig);
  folder.write("thing/model.sdf", "<html version='1.5'/>");
  EXPECT_EQ(
    load(),
    "thing/model.sdf: html: is no model, allowed are <robot> (URDF) and <sdf>; included by test.world: "
    "world[w]/include[0]");
}

TEST_F(LoadWorldErrorsOfIncludes, MissingModelFile)
{
  folder.write("thing/model.config", kConfig);
  EXPECT_EQ(load(), "test.world: world[w]/include[0]/uri: uri[model://thing]: thing/model.sdf is not there");
}

TEST_F(LoadWorldErrorsOfIncludes, MalformedModelFileIsNamed)
{
  folder.write("thing/model.config", kConfig);
  folder.write("thing/model.sdf", "<sdf version='1.6'>\n<model name='thing'>\n<link></model></sdf>");
  EXPECT_EQ(
    load(),
    "thing/model.sdf: line 3: malformed XML: MISMATCHED_ELEMENT, XMLElement name=link; included by test.world: "
    "world[w]/include[0]");
}
}  // namespace
}  // namespace f1tenth_sim2d
