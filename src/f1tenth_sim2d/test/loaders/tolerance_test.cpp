// What Gazebo takes from files that others made, although it is not as it should be.
#include <gtest/gtest.h>

#include <cmath>

#include "f1tenth_sim2d/loaders.h"
#include "f1tenth_sim2d/section.h"
#include "loaders/shapes/child_process.h"
#include "mesh_files.h"
#include "polygons.h"
#include "temp_folder.h"

namespace f1tenth_sim2d
{
namespace
{
const char * const kHead = "<sdf version='1.6'><world name='w'>";
const char * const kTail = "</world></sdf>";
const char * const kBoxXml = "<collision name='c'><geometry><box><size>1 1 1</size></box></geometry></collision>";

class Tolerance : public testing::Test
{
protected:
  WorldDescription loadFile(const std::string & text) const { return loadWorld(folder.write("x.world", text)); }
  WorldDescription load(const std::string & inside) const { return loadFile(kHead + inside + kTail); }

  /// The warnings, without the folder of the file.
  std::vector<std::string> warningsOf(const WorldDescription & world) const
  {
    std::vector<std::string> warnings;
    for (const std::string & warning : world.warnings) {
      warnings.push_back(withoutFolder(warning, folder));
    }
    return warnings;
  }

  void addModel(const std::string & name, const std::string & inside) const
  {
    folder.write("models/" + name + "/model.config", "<model><sdf version='1.6'>model.sdf</sdf></model>");
    folder.write("models/" + name + "/model.sdf", "<sdf version='1.6'>" + inside + "</sdf>");
  }

  TempFolder folder;
};

using Warnings = std::vector<std::string>;

TEST_F(Tolerance, TakesAnInertiaThatNoBodyHasOfWhatStandsStill)
{
  const WorldDescription world = load(
    "<model name='m'><static>1</static><link name='l'><inertial><mass>0</mass><inertia><ixx>0</ixx><iyy>0</iyy>"
    "<izz>0</izz></inertia></inertial>" +
    std::string(kBoxXml) + "</link></model>");
  EXPECT_EQ(
    warningsOf(world),
    Warnings{
      "x.world:1: world[w]/model[m]/link[l]/inertial: no body has this mass and inertia; only mass and yaw inertia "
      "of what moves are used"});
}

TEST_F(Tolerance, TakesALinkWithoutInertiaBesideOneThatHasSome)
{
  const WorldDescription world = load(
    "<model name='m'><link name='l'>" + std::string(kBoxXml) +
    "</link><link "
    "name='flat'><inertial><mass>1</mass><inertia><ixx>5</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>"
    "</link></model>");
  EXPECT_EQ(world.models.at(0).mass, 2.0);
  EXPECT_EQ(world.models.at(0).inertia_zz, 2.0);
  EXPECT_EQ(world.warnings.size(), 1u);
}

TEST_F(Tolerance, RefusesWhatMovesWithoutMass)
{
  const std::string message = loadErrorOf([this] {
    load(
      "<model name='m'><link name='l'><inertial><mass>0</mass></inertial>" + std::string(kBoxXml) + "</link></model>");
  });
  EXPECT_EQ(
    withoutFolder(message, folder),
    "x.world: world[w]/model[m]: can be pushed, but has a mass (kg) of 0; allowed are finite numbers greater than 0, "
    "or "
    "<static>true</static>");
}

TEST_F(Tolerance, TakesModelsThatAreMadeOfOthersAlone)
{
  addModel("block", "<model name='block'><link name='l'>" + std::string(kBoxXml) + "</link></model>");
  addModel(
    "pair",
    "<model name='pair'><include><uri>model://block</uri><name>a</name></include>"
    "<include><uri>model://block</uri><name>b</name><pose>2 0 0 0 0 0</pose></include>"
    "<joint name='j' type='revolute'><parent>a::l</parent><child>b::l</child><axis><xyz>0 0 "
    "1</xyz></axis></joint></model>");
  const WorldDescription world = load("<include><uri>model://pair</uri></include>");
  ASSERT_EQ(world.models.size(), 1u);
  EXPECT_EQ(world.models[0].name, "pair");
  EXPECT_EQ(world.models[0].solids.size(), 2u);
  EXPECT_EQ(world.models[0].mass, 2.0);
  EXPECT_EQ(world.models[0].centre_of_mass.x, 1.0);
  EXPECT_EQ(
    warningsOf(world),
    Warnings{"models/pair/model.sdf:1: model[pair]/joint[j]: <joint> does not move: a model is one rigid body"});
}

TEST_F(Tolerance, TakesFrictionBelowZeroAsEndless)
{
  const WorldDescription world = load(
    "<model name='m'><link name='l'><collision name='c'><geometry><sphere><radius>1</radius></sphere></geometry>"
    "<surface><friction><ode><mu>-1</mu></ode></friction></surface></collision></link></model>");
  EXPECT_EQ(world.models.at(0).solids.at(0).mu, 1e6);
  EXPECT_EQ(
    warningsOf(world),
    Warnings{"x.world:1: world[w]/model[m]/link[l]/collision[c]/surface/friction/ode: friction of less than 0 "
             "is taken as endless, as Gazebo does"});
}

TEST_F(Tolerance, TakesABounceOfMoreThanItHitAsAWholeOne)
{
  const WorldDescription world = load(
    "<model name='m'><link name='l'><collision name='c'><geometry><sphere><radius>1</radius></sphere></geometry>"
    "<surface><bounce><restitution_coefficient>5</restitution_coefficient></bounce></surface></collision></link>"
    "</model>");
  EXPECT_EQ(world.models.at(0).solids.at(0).restitution, 1.0);
  EXPECT_EQ(
    warningsOf(world),
    Warnings{"x.world:1: world[w]/model[m]/link[l]/collision[c]/surface/bounce: restitution_coefficient beyond 1 is "
             "taken as 1: no bounce gives more than it takes"});
}

TEST_F(Tolerance, TakesTwoCollisionsOfOneName)
{
  const std::string ball = "<collision name='c'><geometry><sphere><radius>1</radius></sphere></geometry></collision>";
  const WorldDescription world = load("<model name='m'><link name='l'>" + ball + ball + "</link></model>");
  EXPECT_EQ(world.models.at(0).solids.size(), 2u);
  EXPECT_EQ(
    warningsOf(world),
    Warnings{"x.world:1: world[w]/model[m]/link[l]/collision[c]: this name is taken by another collision of the link: "
             "contacts of both have it"});
}

TEST_F(Tolerance, TakesFrictionBeyondTheEndlessAsEndless)
{
  const WorldDescription world = load(
    "<model name='m'><link name='l'><collision name='c'><geometry><sphere><radius>1</radius></sphere></geometry>"
    "<surface><friction><ode><mu>1e300</mu></ode></friction></surface></collision></link></model>");
  EXPECT_EQ(world.models.at(0).solids.at(0).mu, 1e6);
  EXPECT_EQ(
    warningsOf(world),
    Warnings{"x.world:1: world[w]/model[m]/link[l]/collision[c]/surface/friction/ode: friction beyond 1e6 is taken as "
             "1e6: nothing slips with less, either"});
}

TEST_F(Tolerance, WarnsOfIncludesWithoutModel)
{
  folder.write("models/sun/model.config", "<model><sdf version='1.6'>model.sdf</sdf></model>");
  folder.write("models/sun/model.sdf", "<sdf version='1.6'><light name='sun' type='directional'/></sdf>");
  EXPECT_EQ(warningsOf(load("<include><uri>model://sun</uri></include>")), Warnings{});
  addModel("place", "<world name='w'/>");
  addModel("nothing", "");
  EXPECT_EQ(
    warningsOf(load("<include><uri>model://place</uri></include>\n<include><uri>model://nothing</uri></include>")),
    Warnings{"x.world:1: world[w]/include[0] and 1 more: the file that it includes holds no <model>: left out"});
}

TEST_F(Tolerance, TakesEveryWordForDegrees)
{
  for (const std::string word : {"true", "1", "True"}) {
    const WorldDescription world = load(
      "<model name='m'><pose degrees='" + word + "'>0 0 0 0 0 90</pose><link name='l'>" + kBoxXml + "</link></model>");
    EXPECT_NEAR(world.models.at(0).pose.yaw(), M_PI / 2, 1e-12) << word;
  }
  for (const std::string word : {"degrees='false'", "degrees='0'", "rotation_format='euler_rpy'"}) {
    const WorldDescription world =
      load("<model name='m'><pose " + word + ">0 0 0 0 0 0.5</pose><link name='l'>" + kBoxXml + "</link></model>");
    EXPECT_NEAR(world.models.at(0).pose.yaw(), 0.5, 1e-12) << word;
  }
}

TEST_F(Tolerance, TakesAJointCalledWorld)
{
  const WorldDescription world = load(
    "<model name='m'><link name='l'>" + std::string(kBoxXml) +
    "</link><joint name='world' type='fixed'><parent>world</parent><child>l</child></joint></model>");
  EXPECT_TRUE(world.models.at(0).is_static);
  EXPECT_EQ(
    warningsOf(world),
    Warnings{"x.world:1: world[w]/model[m]/joint[world]: the name 'world' is reserved for the world itself"});
}

TEST_F(Tolerance, TakesAPoseInAFrameWithoutName)
{
  for (const char * const frame : {"frame=''", "frame="}) {
    const WorldDescription world = load(
      "<model name='m'><pose " + std::string(frame) + ">1 2 3 0 0 0</pose><link name='l'>" + kBoxXml +
      "</link></model>");
    EXPECT_EQ(world.models.at(0).pose.position, Eigen::Vector3d(1, 2, 3)) << frame;
  }
}

TEST_F(Tolerance, TakesACommentBeforeTheDeclaration)
{
  const std::string rest = "<?xml version='1.0'?>\n" + std::string(kHead) + "<model name='m'><link name='l'>" +
                           kBoxXml + "</link></model>" + kTail;
  EXPECT_EQ(loadFile("<!-- made by hand -->\n" + rest).models.size(), 1u);
  EXPECT_EQ(loadFile("\n " + rest).models.size(), 1u);
}

TEST_F(Tolerance, TakesAttributesWithoutQuotes)
{
  const WorldDescription world = loadFile(
    "<sdf version=1.6>\n<world name=w><model name=m><link name=l>" + std::string(kBoxXml) + "</link></model>" + kTail);
  EXPECT_EQ(world.models.at(0).name, "m");
  EXPECT_EQ(
    warningsOf(world),
    Warnings{"x.world: line 1: malformed XML: PARSING_ATTRIBUTE, XMLElement name=sdf: read as Gazebo does"});
}

TEST_F(Tolerance, FindsModelsAfterThreeSlashes)
{
  addModel("block", "<model name='block'><link name='l'>" + std::string(kBoxXml) + "</link></model>");
  EXPECT_EQ(load("<include><uri>model:///block</uri></include>").models.size(), 1u);
}

TEST_F(Tolerance, ReadsEveryPolylineOfAGeometry)
{
  const WorldDescription world = load(
    "<model name='m'><link name='l'><collision name='c'><geometry>"
    "<polyline><point>0 0</point><point>4 0</point><point>4 4</point><point>0 4</point><height>1</height></polyline>"
    "<polyline><point>1 1</point><point>2 1</point><point>2 2</point><point>1 2</point><height>1</height></polyline>"
    "<polyline><point>9 0</point><point>10 0</point><point>10 1</point><height>1</height></polyline>"
    "</geometry></collision></link></model>");
  const Solid & solid = world.models.at(0).solids.at(0);
  EXPECT_DOUBLE_EQ(areaOf(sectionAt(solid, solid.pose, 0.5).outlines), 15.5);  // the second one is a hole in the first
}

TEST_F(Tolerance, ReadsCapsulesAndEllipsoids)
{
  const auto radius_at = [this](const std::string & geometry, double z) {
    const WorldDescription world = load(
      "<model name='m'><link name='l'><collision name='c'><geometry>" + geometry +
      "</geometry></collision></link></model>");
    const Solid & solid = world.models.at(0).solids.at(0);
    return sectionAt(solid, solid.pose, z).circles.at(0).radius;
  };
  const std::string capsule = "<capsule><radius>0.5</radius><length>2</length></capsule>";
  EXPECT_DOUBLE_EQ(radius_at(capsule, 0.9), 0.5);
  EXPECT_DOUBLE_EQ(radius_at(capsule, 1.3), 0.4);
  EXPECT_DOUBLE_EQ(radius_at("<ellipsoid><radii>1 1 0.5</radii></ellipsoid>", 0.3), 0.8);
}

/// A model with a mesh.
std::string meshModel(const std::string & mesh)
{
  return "<model name='m'><static>1</static><link name='l'><collision name='c'><geometry><mesh>" + mesh +
         "</mesh></geometry></collision></link></model>";
}

std::size_t trianglesOf(const WorldDescription & world)
{
  return std::get<Mesh>(world.models.at(0).solids.at(0).shape).surface->triangles.size();
}

TEST_F(Tolerance, ReadsMeshesWhateverIsWrongWithTheirLooks)
{
  const std::string dae = daeTetrahedron("<unit meter=\"1\"/><up_axis>Z_UP</up_axis>");
  const auto color = [](const std::string & numbers) {
    return "<library_effects><effect id='e'><profile_COMMON><technique sid='c'><lambert><diffuse><color>" + numbers +
           "</color></diffuse></lambert></technique></profile_COMMON></effect></library_effects>";
  };
  const std::pair<std::string, std::string> odd[]{
    {"<library_geometries>", "<library_images><image id='i'><init_from>file://</init_from></image></library_images>"},
    {"<library_geometries>", color(" 0.3 0.4 0.5 1")},
    {"<library_geometries>", color("red")},
    {"<input semantic=\"POSITION\"", "<!-- no normals -->"},
    {"<library_geometries>", "<!-- made by hand -->"}};
  int number = 0;
  for (const auto & [before, added] : odd) {
    std::string text = dae;
    text.insert(text.find(before), added);
    const std::string file = "peak" + std::to_string(++number) + ".dae";
    folder.write(file, text);
    EXPECT_EQ(trianglesOf(load(meshModel("<uri>" + file + "</uri>"))), 4u) << added;
  }
}

TEST_F(Tolerance, LeavesOutTrianglesThatReachTooFar)
{
  folder.write("far.obj", objBox("block", {0, 0, 0}, {1, 1, 1}) + "v 1e6 0 0\nf 1 2 9\n");
  const WorldDescription world = load(meshModel("<uri>far.obj</uri>"));
  EXPECT_EQ(trianglesOf(world), 12u);
  EXPECT_NE(
    warningsOf(world).at(0).find("far.obj with a corner that is not finite or farther than 100 km"), std::string::npos);
}

TEST_F(Tolerance, LeavesOutAMeshWithAScaleOfZero)
{
  folder.write("block.obj", objBox("block", {0, 0, 0}, {1, 1, 1}));
  const WorldDescription world = load(meshModel("<uri>block.obj</uri><scale>1 0 0</scale>"));
  EXPECT_TRUE(world.models.at(0).solids.empty());
  EXPECT_EQ(
    warningsOf(world),
    Warnings{
      "x.world:1: world[w]/model[m]/link[l]/collision[c]/geometry/mesh: a mesh with a <scale> of 0 is left out"});
  const WorldDescription saved = load(
    meshModel("<uri>block.obj</uri>") + "<state world_name='w'><model name='m'><scale>1 0 1</scale></model></state>");
  EXPECT_TRUE(saved.models.at(0).solids.empty());
  EXPECT_EQ(
    warningsOf(saved), Warnings{"x.world:1: world[w]/state/model[m]: a model with a <scale> of 0 has no collisions"});
}

TEST_F(Tolerance, GivesAModelWhoseNameIsTakenANumber)
{
  addModel("block", "<model name='block'><static>1</static><link name='l'>" + std::string(kBoxXml) + "</link></model>");
  const std::string include = "<include><uri>model://block</uri><pose>0 0 0 0 0 0</pose></include>";
  const std::string other = "\n<include><uri>model://block</uri><pose>5 0 0 0 0 0</pose></include>";
  const WorldDescription world = load(include + other + "<model name='block_1'><link name='l'/></model>");
  ASSERT_EQ(world.models.size(), 3u);
  EXPECT_EQ(world.models[0].name, "block");
  EXPECT_EQ(world.models[1].name, "block_1");
  EXPECT_EQ(world.models[1].pose.position.x(), 5.0);
  EXPECT_EQ(world.models[2].name, "block_1_1");
  EXPECT_EQ(
    warningsOf(world), (Warnings{
                         "x.world:2: world[w]/include[1]: the name 'block' is taken: called 'block_1' here",
                         "x.world:2: world[w]/model[block_1]: the name 'block_1' is taken: called 'block_1_1' here"}));
  addModel("pair", "<model name='pair'>" + include + other + "</model>");
  EXPECT_EQ(load("<include><uri>model://pair</uri></include>").models.at(0).solids.size(), 2u);
}

std::string errorOfShell(const std::string & script)
{
  try {
    return outputOf({"/bin/sh", "-c", script});
  } catch (const Error & error) {
    return error.what();
  }
}

TEST(OutputOf, IsWhatTheProgramWritesToItsDescriptor)
{
  EXPECT_EQ(outputOf({"/bin/sh", "-c", "echo chatter; echo noise >&2; printf x >&3"}), "x");
  EXPECT_EQ(outputOf({"/bin/sh", "-c", "head -c 1000000 /dev/zero >&3"}).size(), 1000000u);
}

TEST(OutputOf, IsAnErrorHoweverTheProgramFails)
{
  EXPECT_EQ(errorOfShell("printf 'no such thing' >&3; exit 1"), "no such thing");
  EXPECT_EQ(errorOfShell("exit 1"), "cannot be read");
  EXPECT_EQ(errorOfShell("kill -ABRT $$"), "crashes what reads it (Aborted)");
  EXPECT_EQ(errorOfShell("kill -XCPU $$"), "takes longer than 60 s of the processor's time to read");
  EXPECT_EQ(errorOfShell("kill -ALRM $$"), "takes longer than 600 s to read");
  EXPECT_EQ(errorOfShell("kill -KILL $$"), "what reads it is killed, as when memory runs out");
  try {
    outputOf({"/nowhere/reader"});
    FAIL() << "nothing thrown";
  } catch (const Error & error) {
    EXPECT_STREQ(error.what(), "cannot be read: /nowhere/reader cannot be started: No such file or directory");
  }
}
}  // namespace
}  // namespace f1tenth_sim2d
