#include <gtest/gtest.h>

#include <cmath>

#include "f1tenth_sim2d/loaders.h"
#include "f1tenth_sim2d/section.h"
#include "temp_folder.h"

namespace f1tenth_sim2d
{
namespace
{
std::string world(const std::string & inside, const std::string & version = "1.6")
{
  return "<?xml version='1.0'?>\n<sdf version='" + version + "'>\n<world name='test'>\n" + inside +
         "\n</world>\n</sdf>\n";
}

std::string model(const std::string & name, const std::string & before_link, const std::string & geometry)
{
  return "<model name='" + name + "'>" + before_link + "<link name='link'><collision name='collision'><geometry>" +
         geometry + "</geometry></collision></link></model>";
}

const char * const kUnitBox = "<box><size>1 1 1</size></box>";

WorldDescription loadText(const std::string & inside, const std::string & version = "1.6")
{
  const TempFolder folder;
  return loadWorld(folder.write("test.world", world(inside, version)));
}

TEST(LoadWorld, ReadsEveryShape)
{
  const WorldDescription description = loadText(
    model("box", "<static>true</static>", "<box><size>1 2 3</size></box>") +
    model("cylinder", "", "<cylinder><radius>0.5</radius><length>2</length></cylinder>") +
    model("sphere", "", "<sphere><radius>0.25</radius></sphere>") +
    model(
      "polyline", "",
      "<polyline><point>0 0</point><point>0 1</point><point>1 0</point><point>0 0</point>"
      "<height>2</height></polyline>") +
    model("plane", "", "<plane><normal>0 0 1</normal><size>10 10</size></plane>"));
  ASSERT_EQ(description.models.size(), 5u);
  EXPECT_EQ(description.name, "test");
  EXPECT_EQ(std::get<Box>(description.models[0].solids.at(0).shape).size, Eigen::Vector3d(1, 2, 3));
  EXPECT_TRUE(description.models[0].is_static);
  EXPECT_FALSE(description.models[1].is_static);
  EXPECT_EQ(std::get<Cylinder>(description.models[1].solids.at(0).shape).length, 2.0);
  EXPECT_EQ(std::get<Sphere>(description.models[2].solids.at(0).shape).radius, 0.25);
  const Polyline polyline = std::get<Polyline>(description.models[3].solids.at(0).shape);
  EXPECT_EQ(polyline.outlines.at(0).size(), 3u);
  EXPECT_EQ(polyline.height, 2.0);
  EXPECT_TRUE(std::holds_alternative<Plane>(description.models[4].solids.at(0).shape));
  EXPECT_TRUE(description.warnings.empty());
}

TEST(LoadWorld, ReadsFrictionAndBounce)
{
  const WorldDescription description = loadText(
    "<model name='ball'><link name='link'><collision name='collision'><geometry><sphere><radius>1</radius></sphere>"
    "</geometry><surface><friction><ode><mu>0.4</mu></ode></friction><bounce><restitution_coefficient>0.7"
    "</restitution_coefficient></bounce></surface></collision></link></model>");
  EXPECT_EQ(description.models[0].solids[0].mu, 0.4);
  EXPECT_EQ(description.models[0].solids[0].restitution, 0.7);
}

TEST(LoadWorld, PosesAddUpFromModelOverLinkToCollision)
{
  const WorldDescription description = loadText(
    "<model name='m'><pose>10 0 0 0 0 1.5707963267948966</pose><link name='l'><pose>1 0 0 0 0 0</pose>"
    "<collision name='c'><pose>0 2 0.5 0 0 0</pose><geometry><sphere><radius>1</radius></sphere></geometry>"
    "</collision></link></model>");
  const ModelDescription & m = description.models[0];
  EXPECT_EQ(m.solids[0].name, "m::l::c");
  EXPECT_EQ(m.solids[0].pose.position, Eigen::Vector3d(1, 2, 0.5));
  const auto in_world = (m.pose * m.solids[0].pose).position;
  EXPECT_NEAR(in_world.x(), 8.0, 1e-9);
  EXPECT_NEAR(in_world.y(), 1.0, 1e-9);
}

TEST(LoadWorld, ResolvesFramesAndRelativePoses)
{
  const WorldDescription description = loadText(
    "<frame name='corner'><pose>5 5 0 0 0 0</pose></frame>"
    "<model name='m'><pose relative_to='corner'>1 0 0 0 0 0</pose><frame name='f'><pose>0 0 2 0 0 0</pose></frame>"
    "<link name='l'><pose relative_to='f'>0 0 1 0 0 0</pose><collision name='c'><pose relative_to='f'>0 1 0 0 0 0"
    "</pose><geometry><sphere><radius>1</radius></sphere></geometry></collision></link></model>",
    "1.9");
  EXPECT_EQ(description.models[0].pose.position, Eigen::Vector3d(6, 5, 0));
  EXPECT_EQ(description.models[0].solids[0].pose.position, Eigen::Vector3d(0, 1, 2));
}

TEST(LoadWorld, LinksOfAModelAreOneRigidBody)
{
  const std::string inertial =
    "<inertial><mass>2</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>0.5</izz></inertia></inertial>";
  const WorldDescription description = loadText(
    "<model name='m'><link name='a'><pose>-1 0 0 0 0 0</pose>" + inertial +
    "</link><link name='b'><pose>3 0 0 0 0 0</pose>" + inertial + "</link></model>");
  const ModelDescription & m = description.models[0];
  EXPECT_NEAR(m.mass, 4.0, 1e-12);
  EXPECT_NEAR(m.centre_of_mass.x, 1.0, 1e-12);
  EXPECT_NEAR(m.centre_of_mass.y, 0.0, 1e-12);
  EXPECT_NEAR(m.inertia_zz, 2 * 0.5 + 4.0 * 2.0 * 2.0, 1e-9);
}

TEST(LoadWorld, NestedModelsGetScopedNamesAndTheOutermostPose)
{
  const WorldDescription description = loadText(
    "<model name='outer'><static>true</static><pose>1 0 0 0 0 0</pose><link name='l'/><model name='inner'>"
    "<pose>0 1 0 0 0 0</pose><link name='l'><collision name='c'><geometry><sphere><radius>1</radius></sphere>"
    "</geometry></collision></link></model></model>",
    "1.9");
  ASSERT_EQ(description.models.size(), 2u);
  EXPECT_EQ(description.models[1].name, "outer::inner");
  EXPECT_TRUE(description.models[1].is_static);
  EXPECT_EQ(description.models[1].pose.position, Eigen::Vector3d(1, 1, 0));
  EXPECT_EQ(description.models[1].solids[0].name, "outer::inner::l::c");
}

TEST(LoadWorld, ModelsMadeOfOthersThatDoNotMoveApartAreOneBody)
{
  const std::string parts =
    "<model name='a'><link name='l'><collision name='c'><geometry><sphere><radius>1</radius></sphere></geometry>"
    "</collision></link></model><model name='b'><static>1</static><link name='l'/></model>";
  const std::string single = parts.substr(0, parts.rfind("<model"));
  const auto load = [](const std::string & inside) {
    return loadText("<model name='m'>" + inside + "</model>").models;
  };
  for (const std::string & inside : {single, "<static>1</static>" + parts}) {
    const std::vector<ModelDescription> models = load(inside);
    ASSERT_EQ(models.size(), 1u);
    EXPECT_EQ(models[0].name, "m");
    EXPECT_EQ(models[0].solids.at(0).name, "m::a::l::c");
    EXPECT_EQ(models[0].is_static, inside != single);
  }
  EXPECT_TRUE(load(parts.substr(parts.rfind("<model"))).at(0).is_static);
  EXPECT_EQ(load(parts).size(), 2u);
  const std::vector<ModelDescription> twice =
    load("<model name='n'>" + parts.substr(parts.rfind("<model")) + "</model>");
  ASSERT_EQ(twice.size(), 1u);
  EXPECT_TRUE(twice[0].is_static);
}

TEST(LoadWorld, TurnsAPlaneToItsNormal)
{
  const WorldDescription description =
    loadText(model("m", "", "<plane><normal>1 0 0</normal><size>1 1</size></plane>"));
  const auto up = description.models[0].solids[0].pose.up();
  EXPECT_NEAR(up.x(), 1.0, 1e-12);
}

TEST(LoadWorld, StartsFromTheStateThatGazeboSaved)
{
  const WorldDescription description = loadText(
    model("m", "<pose>1 1 0 0 0 0</pose>", kUnitBox) +
    "<state world_name='test'><model name='m'><pose>7 8 0 0 0 0.5</pose></model></state>");
  EXPECT_EQ(description.models[0].pose.position, Eigen::Vector3d(7, 8, 0));
  EXPECT_NEAR(description.models[0].pose.yaw(), 0.5, 1e-12);
}

TEST(LoadWorld, ScalesModelsAsTheStateSays)
{
  const std::string state = "<state world_name='test'><model name='m'><scale>0.5 4 2</scale></model></state>";
  const auto shape_of = [&state](const std::string & geometry) {
    return loadText(model("m", "", geometry) + state).models.at(0).solids.at(0).shape;
  };
  EXPECT_EQ(std::get<Box>(shape_of(kUnitBox)).size, Eigen::Vector3d(0.5, 4, 2));
  const auto cylinder = std::get<Cylinder>(shape_of("<cylinder><radius>1</radius><length>3</length></cylinder>"));
  EXPECT_EQ(cylinder.radius, 4.0);
  EXPECT_EQ(cylinder.length, 6.0);
  EXPECT_EQ(std::get<Sphere>(shape_of("<sphere><radius>1</radius></sphere>")).radius, 4.0);
}

TEST(LoadWorld, ScalesMeshesAsTheStateSays)
{
  const TempFolder folder;
  folder.write("slope.obj", "v 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n");
  const std::string mesh = "<mesh><uri>slope.obj</uri><scale>2 2 2</scale></mesh>";
  const std::string path = folder.write(
    "test.world", world(
                    model("m", "", mesh) + model("n", "", mesh) +
                    "<state world_name='test'><model name='m'><scale>0.5 4 3</scale></model></state>"));
  const WorldDescription description = loadWorld(path);
  const auto vertex = [&description](std::size_t index) {
    return std::get<Mesh>(description.models.at(index).solids.at(0).shape).surface->vertices.at(2);
  };
  EXPECT_EQ(vertex(0), Eigen::Vector3d(0, 8, 6));
  EXPECT_EQ(vertex(1), Eigen::Vector3d(0, 2, 2));
}

TEST(LoadWorld, PutsLinksAndNestedModelsWhereTheStateSays)
{
  const WorldDescription description = loadText(
    "<model name='m'><link name='a'/><link name='b'><inertial><mass>3</mass></inertial><collision name='c'>"
    "<pose>0 0 1 0 0 0</pose><geometry><sphere><radius>1</radius></sphere></geometry></collision></link>"
    "<model name='n'><link name='l'/></model></model>"
    "<state world_name='test'><model name='m'><pose>1 0 0 0 0 1.5707963267948966</pose>"
    "<link name='a'><pose>1 0.0001 0 0 0 1.5708</pose></link><link name='b'><pose>1 4 0 0 0 1.5707963267948966</pose>"
    "</link><model name='n'><pose>5 6 0 0 0 0</pose></model></model></state>");
  const ModelDescription & m = description.models.at(0);
  EXPECT_TRUE(m.solids.at(0).pose.position.isApprox(Eigen::Vector3d(4, 0, 1))) << m.solids[0].pose.position.transpose();
  EXPECT_NEAR(m.centre_of_mass.x, 3.0, 1e-12);  // the first link is where it was but for the rounding of the file
  EXPECT_TRUE(description.models.at(1).pose.position.isApprox(Eigen::Vector3d(5, 6, 0)));
}

TEST(LoadWorld, ReadsGravity)
{
  EXPECT_NEAR(loadText("<gravity>0 0 -1.62</gravity>").gravity, 1.62, 1e-12);
}

TEST(LoadWorld, ReadsModelsWithTheOlderNameOfTheirDescription)
{
  const TempFolder folder;
  folder.write("block/manifest.xml", "<model><name>block</name><sdf version='1.6'>model.sdf</sdf></model>");
  folder.write("block/model.sdf", "<sdf version='1.6'><model name='old'><link name='link'/></model></sdf>");
  const std::string file = folder.write("test.world", world("<include><uri>model://block</uri></include>"));
  EXPECT_EQ(loadWorld(file).models.at(0).name, "old");
}

TEST(LoadWorld, FindsModelsOnTheModelPathFirstThenBesideTheWorld)
{
  const TempFolder folder;
  const auto add_model = [&folder](const std::string & place, const std::string & size) {
    folder.write(place + "/model.config", "<model><name>block</name><sdf version='1.6'>model.sdf</sdf></model>");
    folder.write(
      place + "/model.sdf",
      "<sdf version='1.6'><model name='block'><link name='link'><collision name='c'><geometry>"
      "<box><size>" +
        size + "</size></box></geometry></collision></link></model></sdf>");
  };
  add_model("path/block", "1 1 1");
  add_model("worlds/block", "2 2 2");
  add_model("models/crate", "3 3 3");
  const std::string file = folder.write(
    "worlds/test.world", world(
                           "<include><uri>model://block</uri></include><include><name>c</name><pose>4 0 0 0 0 0"
                           "</pose><uri>model://crate</uri></include><include><name>f</name><uri>file://" +
                           folder.path() + "/models/crate</uri></include>"));
  const auto size_of = [](const ModelDescription & m) { return std::get<Box>(m.solids.at(0).shape).size.x(); };
  const WorldDescription with_path = loadWorld(file, {{folder.path() + "/path"}, {}});
  EXPECT_EQ(size_of(with_path.models.at(0)), 1.0);
  EXPECT_EQ(size_of(with_path.models.at(1)), 3.0);
  EXPECT_EQ(with_path.models.at(1).name, "c");
  EXPECT_EQ(with_path.models.at(1).pose.position.x(), 4.0);
  EXPECT_EQ(size_of(with_path.models.at(2)), 3.0);
  EXPECT_EQ(size_of(loadWorld(file).models.at(0)), 2.0);
}

TEST(LoadWorldWarnings, AreOneAKindWithTheFirstPlaceAndACount)
{
  const WorldDescription description = loadText(
    "<plugin name='p' filename='libp.so'/><plugin name='q' filename='libq.so'/>"
    "<actor name='walker'><skin><filename>x.dae</filename></skin></actor>"
    "<model name='door'><link name='a'><sensor name='s' type='altimeter'/></link>"
    "<link name='b'/><joint name='hinge' type='revolute'><parent>a</parent><child>b</child><axis><xyz>0 0 1</xyz>"
    "</axis></joint><plugin name='opener' filename='libo.so'/><colour>red</colour></model>");
  const std::vector<std::string> expected{
    "world[test]/plugin[p] and 1 more: <plugin> of a world is left out: only cars have plugins",
    "world[test]/actor[walker]: <actor> of a world is left out: it has no collision",
    "world[test]/model[door]/colour: is not an element of SDF and left out",
    "world[test]/model[door]/plugin[opener]: <plugin> of a model is left out: only cars have plugins",
    "world[test]/model[door]/link[a]/sensor[s]: <sensor> is left out: only cars have sensors",
    "world[test]/model[door]/joint[hinge]: <joint> does not move: a model is one rigid body",
  };
  ASSERT_EQ(description.warnings.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(description.warnings[i], description.file + ":4: " + expected[i]);
  }
}

std::string warningOf(const std::string & inside)
{
  const WorldDescription description = loadText(inside);
  return description.warnings.size() == 1 ? description.warnings[0].substr(description.file.size()) : "not one";
}

TEST(LoadWorldWarnings, CollisionsThatGazeboLetsPass)
{
  const auto with_contact = [](const std::string & contact) {
    return "<model name='m'><link name='l'><collision name='c'><geometry><sphere><radius>1</radius></sphere></geometry>"
           "<surface><contact>" +
           contact + "</contact></surface></collision></link></model>";
  };
  const std::string place = ":4: world[test]/model[m]/link[l]/collision[c]/surface/contact: ";
  EXPECT_EQ(
    warningOf(with_contact("<collide_without_contact>1</collide_without_contact>")),
    place + "<collide_without_contact> is left out: what a lidar sees is solid");
  for (const char * const nothing : {"0", "0x00"}) {
    EXPECT_EQ(
      warningOf(with_contact(std::string("<collide_bitmask>") + nothing + "</collide_bitmask>")),
      place + "<collide_bitmask> of 0 is left out: what a lidar sees is solid");
  }
  EXPECT_TRUE(loadText(with_contact("<collide_bitmask>0x02</collide_bitmask>")).warnings.empty());
}

TEST(LoadWorldWarnings, JointsOfWhatIsFixedToTheWorld)
{
  EXPECT_EQ(
    warningOf(
      "<model name='door'><link name='frame'/><link name='leaf'/><joint name='wall' type='fixed'><parent>world</parent>"
      "<child>frame</child></joint><joint name='hinge' "
      "type='revolute'><parent>frame</parent><child>leaf</child></joint>"
      "</model>"),
    ":4: world[test]/model[door]/joint[hinge]: <joint> does not move: a model is one rigid body");
}

TEST(LoadWorldWarnings, PlanesThatAreNotLevel)
{
  const std::string left_out =
    ":4: world[test]/model[m]/link[link]: <plane> that is not level is left out: the ground is level";
  EXPECT_EQ(warningOf(model("m", "", "<plane><normal>1 0 0</normal></plane>")), left_out);
  EXPECT_EQ(warningOf(model("m", "<pose>0 0 0 0.01 0 0</pose>", "<plane/>")), left_out);
  EXPECT_TRUE(loadText(model("m", "<pose>0 0 0 0.0001 0 0</pose>", "<plane/>")).warnings.empty());
}

TEST(LoadWorldWarnings, AScaleThatAShapeCannotHave)
{
  const WorldDescription description = loadText(
    model("m", "", "<capsule><radius>1</radius><length>1</length></capsule>") +
    "<state world_name='test'><model name='m'>\n<scale>2 2 2</scale></model></state>");
  const std::string warning =
    ":5: world[test]/state/model[m]/scale: <scale> of a <state> is applied to boxes, cylinders, spheres and meshes "
    "only, "
    "as in Gazebo";
  EXPECT_EQ(description.warnings, std::vector<std::string>{description.file + warning});
}

TEST(LoadWorldWarnings, PhysicsSceneGuiAndLightsAreSilent)
{
  const WorldDescription description = loadText(
    "<light name='sun' type='directional'><direction>0 0 -1</direction></light>"
    "<physics type='ode'><max_step_size>0.001</max_step_size></physics><scene><shadows>1</shadows></scene>"
    "<gui fullscreen='0'/><spherical_coordinates><surface_model>EARTH_WGS84</surface_model></spherical_coordinates>"
    "<magnetic_field>0 0 0</magnetic_field><atmosphere type='adiabatic'/><wind/>");
  EXPECT_TRUE(description.warnings.empty()) << description.warnings.front();
}

TEST(LoadWorld, PrintsNothing)
{
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  const std::string message = loadErrorOf([] { loadText("<model name='m'><pose>1 2 x 0 0 0</pose></model>"); });
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
  EXPECT_NE(message, "nothing thrown");
}

TEST(SearchPathFromEnvironment, IsSplitAtColons)
{
  setenv("GAZEBO_MODEL_PATH", "/a:/b::/c", 1);
  setenv("ROS_PACKAGE_PATH", "/d:/e", 1);
  const SearchPath given = searchPathFromEnvironment();
  EXPECT_EQ(given.model_folders, (std::vector<std::string>{"/a", "/b", "/c"}));
  EXPECT_EQ(given.package_folders, (std::vector<std::string>{"/d", "/e"}));
  unsetenv("GAZEBO_MODEL_PATH");
  unsetenv("ROS_PACKAGE_PATH");
  const SearchPath none = searchPathFromEnvironment();
  EXPECT_TRUE(none.model_folders.empty());
  EXPECT_TRUE(none.package_folders.empty());
}
}  // namespace
}  // namespace f1tenth_sim2d
