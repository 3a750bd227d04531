// What the loaders read of SDF and URDF, compared with what libsdformat reads: on worlds and models made by others, and
// on generated ones.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sdf/sdf.hh>

#include "../temp_folder.h"
#include "loaders/frames/read_pose.h"
#include "loaders/model/model_reader.h"
#include "random_sdf.h"
#include "random_urdf.h"

namespace f1tenth_sim2d
{
namespace
{
namespace fs = std::filesystem;
using ignition::math::Pose3d;

constexpr double kTolerance = 1e-7;        // libsdformat writes the numbers of a URDF as text in between
constexpr double kSensorTolerance = 1e-4;  // and those of moved sensors with six digits

Pose3d resolved(const sdf::SemanticPose & pose, const std::string & frame)
{
  Pose3d result;
  const sdf::Errors errors = pose.Resolve(result, frame);
  EXPECT_TRUE(errors.empty()) << errors.front().Message();
  return result;
}

Pose3 fromIgnition(const Pose3d & pose)
{
  return {
    {pose.Pos().X(), pose.Pos().Y(), pose.Pos().Z()}, {pose.Rot().W(), pose.Rot().X(), pose.Rot().Y(), pose.Rot().Z()}};
}

void expectSame(const Pose3 & ours, const Pose3d & theirs, double tolerance = kTolerance)
{
  const Pose3 other = fromIgnition(theirs);
  EXPECT_LT((ours.position - other.position).norm(), tolerance) << ours.position.transpose() << " | " << theirs;
  EXPECT_LT(ours.rotation.angularDistance(other.rotation), 100 * tolerance) << theirs;
}

/// Numbers that describe a shape.
std::vector<double> sizesOf(const sdf::Geometry & geometry)
{
  if (const auto * box = geometry.BoxShape()) {
    return {box->Size().X(), box->Size().Y(), box->Size().Z()};
  }
  if (const auto * cylinder = geometry.CylinderShape()) {
    return {cylinder->Radius(), cylinder->Length()};
  }
  if (const auto * sphere = geometry.SphereShape()) {
    return {sphere->Radius()};
  }
  if (const auto * capsule = geometry.CapsuleShape()) {
    return {capsule->Radius(), capsule->Length()};
  }
  if (const auto * ellipsoid = geometry.EllipsoidShape()) {
    return {ellipsoid->Radii().X(), ellipsoid->Radii().Y(), ellipsoid->Radii().Z()};
  }
  if (const sdf::ElementPtr polyline = geometry.Element()->FindElement("polyline")) {
    return {polyline->Get<double>("height")};  // libsdformat 12 knows the element, but no shape for it
  }
  return {};
}

std::vector<double> sizesOf(const Shape & shape)
{
  if (const auto * box = std::get_if<Box>(&shape)) {
    return {box->size.x(), box->size.y(), box->size.z()};
  }
  if (const auto * cylinder = std::get_if<Cylinder>(&shape)) {
    return {cylinder->radius, cylinder->length};
  }
  if (const auto * sphere = std::get_if<Sphere>(&shape)) {
    return {sphere->radius};
  }
  if (const auto * capsule = std::get_if<Capsule>(&shape)) {
    return {capsule->radius, capsule->length};
  }
  if (const auto * ellipsoid = std::get_if<Ellipsoid>(&shape)) {
    return {ellipsoid->radii.x(), ellipsoid->radii.y(), ellipsoid->radii.z()};
  }
  if (const auto * polyline = std::get_if<Polyline>(&shape)) {
    return {polyline->height};
  }
  return {};
}

sdf::GeometryType typeOf(const Shape & shape)
{
  using Type = sdf::GeometryType;
  static const std::vector<Type> types{Type::BOX,       Type::CYLINDER, Type::SPHERE, Type::CAPSULE,
                                       Type::ELLIPSOID, Type::EMPTY,    Type::PLANE,  Type::MESH};
  return types.at(shape.index());
}

double numberAt(sdf::ElementPtr element, const std::vector<std::string> & path, double fallback)
{
  for (const std::string & tag : path) {
    if (!element->HasElement(tag)) {
      return fallback;
    }
    element = element->GetElement(tag);
  }
  return element->Get<double>();
}

void expectSame(const Solid & ours, const sdf::Collision & theirs)
{
  SCOPED_TRACE("collision " + ours.name);
  EXPECT_EQ(ours.name, theirs.Name());
  EXPECT_EQ(typeOf(ours.shape), theirs.Geom()->Type());
  const std::vector<double> a = sizesOf(ours.shape);
  const std::vector<double> b = sizesOf(*theirs.Geom());
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_NEAR(a[i], b[i], kTolerance);
  }
  if (const auto * plane = theirs.Geom()->PlaneShape()) {
    const Pose3d pose = resolved(theirs.SemanticPose(), "__model__");
    const auto up = pose.Rot().RotateVector(plane->Normal());
    EXPECT_NEAR((ours.pose.up() - Eigen::Vector3d(up.X(), up.Y(), up.Z())).norm(), 0.0, kTolerance);
  } else {
    expectSame(ours.pose, resolved(theirs.SemanticPose(), "__model__"));
  }
  const double mu = numberAt(theirs.Element(), {"surface", "friction", "ode", "mu"}, 1.0);
  EXPECT_NEAR(ours.mu, mu, kTolerance);
  const double bounce = numberAt(theirs.Element(), {"surface", "bounce", "restitution_coefficient"}, 0.0);
  EXPECT_NEAR(ours.restitution, bounce, kTolerance);
}

void expectSame(const Inertia & ours, const sdf::Link & link)
{
  const ignition::math::Inertiald & theirs = link.Inertial();
  EXPECT_NEAR(ours.mass, theirs.MassMatrix().Mass(), kTolerance);
  const Pose3d centre = resolved(link.SemanticPose(), "__model__") * theirs.Pose();
  EXPECT_NEAR((ours.centre - fromIgnition(centre).position).norm(), 0.0, kTolerance);
  const auto turned = ignition::math::Matrix3d(centre.Rot());
  const auto moments = turned * theirs.MassMatrix().Moi() * turned.Transposed();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      EXPECT_NEAR(
        ours.moments(row, column), moments(static_cast<std::size_t>(row), static_cast<std::size_t>(column)), 1e-6);
    }
  }
}

void expectSame(const LinkPart & ours, const sdf::Link & theirs)
{
  SCOPED_TRACE("link " + ours.name);
  EXPECT_EQ(ours.name, theirs.Name());
  expectSame(ours.pose, resolved(theirs.SemanticPose(), "__model__"));
  expectSame(ours.inertia, theirs);
  ASSERT_EQ(ours.solids.size(), theirs.CollisionCount());
  for (std::size_t i = 0; i < ours.solids.size(); ++i) {
    expectSame(ours.solids[i], *theirs.CollisionByIndex(i));
  }
  ASSERT_EQ(ours.sensors.size(), theirs.SensorCount());
  for (std::size_t i = 0; i < ours.sensors.size(); ++i) {
    EXPECT_EQ(ours.sensors[i].element.name(), theirs.SensorByIndex(i)->Name());
    expectSame(ours.sensors[i].pose, resolved(theirs.SensorByIndex(i)->SemanticPose(), "__model__"), kSensorTolerance);
  }
}

void expectSame(const JointPart & ours, const sdf::Joint & theirs)
{
  SCOPED_TRACE("joint " + ours.name);
  EXPECT_EQ(ours.name, theirs.Name());
  EXPECT_EQ(ours.parent, theirs.ParentLinkName());
  EXPECT_EQ(ours.child, theirs.ChildLinkName());
  expectSame(ours.pose, resolved(theirs.SemanticPose(), "__model__"));
  if (ours.type != "fixed") {
    ASSERT_NE(theirs.Axis(), nullptr);
    ignition::math::Vector3d axis;
    EXPECT_TRUE(theirs.Axis()->ResolveXyz(axis, "__model__").empty());
    EXPECT_NEAR((ours.axis.normalized() - Eigen::Vector3d(axis.X(), axis.Y(), axis.Z())).norm(), 0.0, 1e-6);
    EXPECT_NEAR(std::max(ours.lower, -1e16), std::max(theirs.Axis()->Lower(), -1e16), kTolerance);
    EXPECT_NEAR(std::min(ours.upper, 1e16), std::min(theirs.Axis()->Upper(), 1e16), kTolerance);
  }
}

void expectSameModel(const Model & ours, const sdf::Model & theirs)
{
  SCOPED_TRACE("model " + ours.name);
  EXPECT_EQ(ours.name, theirs.Name());
  EXPECT_EQ(ours.is_static, theirs.Static());
  ASSERT_EQ(ours.links.size(), theirs.LinkCount());
  for (const LinkPart & link : ours.links) {
    ASSERT_NE(theirs.LinkByName(link.name), nullptr) << link.name;
    expectSame(link, *theirs.LinkByName(link.name));
  }
  ASSERT_EQ(ours.joints.size(), theirs.JointCount());
  for (const JointPart & joint : ours.joints) {
    ASSERT_NE(theirs.JointByName(joint.name), nullptr) << joint.name;
    expectSame(joint, *theirs.JointByName(joint.name));
  }
  ASSERT_EQ(ours.models.size(), theirs.ModelCount());
  for (std::size_t i = 0; i < ours.models.size(); ++i) {
    expectSameModel(ours.models[i], *theirs.ModelByIndex(i));
    expectSame(ours.models[i].pose, resolved(theirs.ModelByIndex(i)->SemanticPose(), "__model__"));
  }
  auto plugin = theirs.Element()->FindElement("plugin");
  for (const Element & each : ours.plugins) {
    ASSERT_TRUE(plugin);
    EXPECT_EQ(each.name(), plugin->Get<std::string>("name"));
    EXPECT_EQ(each.attribute("filename"), plugin->Get<std::string>("filename"));
    plugin = plugin->GetNextElement("plugin");
  }
  EXPECT_FALSE(plugin);
}

/// The models of a world with their poses in it.
std::vector<Model> modelsOf(const std::string & path, ModelReader & reader, FrameScope & frames)
{
  const Element world = reader.documents().readFile(path).child("world");
  for (const Element & frame : world.children("frame")) {
    frames.add(frame.name(), readPose(frame, frame.attribute("attached_to")));
  }
  std::vector<Model> models;
  for (const Element & child : world.children()) {
    if (std::optional<Model> model = reader.readNested(child)) {
      nestFrames(*model, frames, reader.warnings());
      models.push_back(std::move(*model));
    }
  }
  return models;
}

void expectSameWorld(const std::string & path, const SearchPath & search_path)
{
  SCOPED_TRACE(path);
  const UriLookup uris(search_path, path);
  WarningCollector warnings;
  ModelReader reader(uris, warnings);
  FrameScope frames;
  const std::vector<Model> models = modelsOf(path, reader, frames);
  sdf::setFindCallback([&uris](const std::string & uri) { return uris.find(uri); });  // for includes in includes, too
  sdf::Root root;
  const sdf::Errors errors = root.Load(path);
  ASSERT_TRUE(errors.empty()) << errors.front().Message();
  const sdf::World & world = *root.WorldByIndex(0);
  ASSERT_EQ(models.size(), world.ModelCount());
  for (std::size_t i = 0; i < models.size(); ++i) {
    expectSameModel(models[i], *world.ModelByIndex(i));
    expectSame(
      frames.poseOf(models[i].name, models[i].element), resolved(world.ModelByIndex(i)->SemanticPose(), "world"));
  }
}

std::size_t collisionsOf(const sdf::Model & model)
{
  std::size_t count = 0;
  for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
    count += model.LinkByIndex(i)->CollisionCount();
  }
  return count;
}

std::size_t collisionsIn(const Element & robot)
{
  std::size_t count = 0;
  for (const Element & link : robot.children("link")) {
    count += link.children("collision").size();
  }
  return count;
}

void expectSameRobot(const std::string & xml)
{
  const UriLookup uris({}, "");
  WarningCollector warnings;
  ModelReader reader(uris, warnings);
  sdf::Root root;
  const sdf::Errors errors = root.LoadSdfString(xml);
  ASSERT_TRUE(errors.empty()) << errors.front().Message();
  const Element robot = reader.documents().readText(xml, "robot");
  if (collisionsOf(*root.Model()) < collisionsIn(robot)) {
    const std::string message = loadErrorOf([&] { reader.readDocument(robot); });
    EXPECT_NE(message.find("so that Gazebo leaves it out"), std::string::npos) << message;
  } else {
    expectSameModel(*reader.readDocument(robot), *root.Model());
  }
}

std::string textOf(const fs::path & path)
{
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

class Oracle : public testing::Test
{
protected:
  void SetUp() override
  {
    // It keeps a log in the home folder.
    setenv("HOME", folder.path().c_str(), 1);
    sdf::Console::Instance()->SetQuiet(true);
    const char * const given = std::getenv("F1TENTH_DATA");
    data = given ? given : F1TENTH_DEFAULT_DATA;
  }

  void requireData() const
  {
    if (!fs::exists(data)) {
      GTEST_SKIP() << "there is no folder " << data << "; F1TENTH_DATA names another one";
    }
  }

  TempFolder folder;
  fs::path data;
};

TEST_F(Oracle, AgreesOnWorldsOfOthers)
{
  requireData();
  if (IsSkipped()) {
    return;
  }
  for (const auto & entry : fs::directory_iterator(data / "worlds")) {
    if (entry.path().extension() == ".world") {
      expectSameWorld(entry.path(), {{data / "gazebo_models"}, {}});
    }
  }
}

TEST_F(Oracle, AgreesOnModelsOfOthers)
{
  requireData();
  if (IsSkipped()) {
    return;
  }
  for (const auto & entry : fs::directory_iterator(data / "gazebo_models")) {
    const std::string world = folder.write(
      "one.world", "<sdf version='1.6'><world name='w'><include><uri>model://" + entry.path().filename().string() +
                     "</uri></include></world></sdf>");
    expectSameWorld(world, {{data / "gazebo_models"}, {}});
  }
}

TEST_F(Oracle, AgreesOnTheWorldsOfTheWorkspace)
{
  for (const auto & entry : fs::directory_iterator(F1TENTH_GAZEBO "/worlds")) {
    if (entry.path().extension() == ".world") {
      expectSameWorld(entry.path(), {{F1TENTH_GAZEBO "/models"}, {}});
    }
  }
}

TEST_F(Oracle, AgreesOnRobotDescriptions)
{
  for (const auto & entry : fs::directory_iterator(F1TENTH_SIM2D_TEST_DATA)) {
    if (entry.path().extension() == ".urdf") {
      SCOPED_TRACE(entry.path().string());
      expectSameRobot(textOf(entry.path()));
    }
  }
}

TEST_F(Oracle, AgreesOnGeneratedWorlds)
{
  for (std::uint32_t seed = 0; seed < 60 && !HasFailure(); ++seed) {
    const TempFolder place;
    const std::string path = writeRandomWorld(seed, place);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + textOf(path));
    expectSameWorld(path, {{place.path() + "/models"}, {}});
  }
}

TEST_F(Oracle, AgreesOnGeneratedRobots)
{
  for (std::uint32_t seed = 0; seed < 60 && !HasFailure(); ++seed) {
    const std::string xml = randomUrdf(seed);
    SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + xml);
    expectSameRobot(xml);
  }
}
}  // namespace
}  // namespace f1tenth_sim2d
