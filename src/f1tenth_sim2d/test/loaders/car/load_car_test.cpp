#include <gtest/gtest.h>

#include <algorithm>

#include "core/components/imu/imu.h"
#include "f1tenth_sim2d/errors.h"
#include "f1tenth_sim2d/loaders.h"
#include "only.h"
#include "small_car.h"

namespace f1tenth_sim2d
{
namespace
{
CarDescription load(const std::string & xml)
{
  return loadCar(xml, "robot1", "test.urdf");
}

bool hasLine(const std::vector<std::string> & list, const std::string & text)
{
  return std::find(list.begin(), list.end(), text) != list.end();
}

const Solid & solidNamed(const CarDescription & car, const std::string & name)
{
  const auto found =
    std::find_if(car.solids.begin(), car.solids.end(), [&name](const Solid & solid) { return solid.name == name; });
  if (found == car.solids.end()) {
    throw std::logic_error("no solid " + name);
  }
  return *found;
}

TEST(LoadCar, KeepsEverySolidInBaseFootprint)
{
  const CarDescription car = load(smallCar());
  EXPECT_EQ(car.name, "robot1");
  EXPECT_EQ(car.source, "test.urdf");
  EXPECT_EQ(car.solids.size(), 9u);
  const Solid & wheel = solidNamed(car, "robot1::front_left_wheel::front_left_wheel_collision");
  EXPECT_NEAR(wheel.pose.position.x(), 0.32, 1e-9);
  EXPECT_NEAR(wheel.pose.position.y(), 0.1, 1e-9);
  EXPECT_NEAR(wheel.pose.position.z(), 0.05, 1e-9);
  const Solid & bumper = solidNamed(car, "robot1::bumper_front::bumper_front_collision");
  EXPECT_NEAR(bumper.pose.position.x(), 0.43, 1e-9);
  EXPECT_NEAR(bumper.pose.position.z(), 0.07, 1e-9);
}

TEST(LoadCar, KnowsLinksThatFixedJointsMakeVanish)
{
  const CarDescription car = load(smallCar());
  for (const char * const link : {"base_footprint", "base_link", "laser", "imu", "bumper_left", "rear_left_wheel"}) {
    EXPECT_TRUE(hasLine(car.links, link)) << link;
  }
  EXPECT_EQ(car.links.size(), 14u);
}

TEST(LoadCar, ReadsTheLidar)
{
  const CarDescription car = load(smallCar());
  ASSERT_EQ(car.lidars.size(), 1u);
  const LidarDescription & lidar = car.lidars[0];
  EXPECT_EQ(lidar.name, "lidar");
  EXPECT_EQ(lidar.topic, "scan");
  EXPECT_EQ(lidar.frame, "laser");
  EXPECT_NEAR(lidar.pose.position.x(), 0.27, 1e-9);
  EXPECT_NEAR(lidar.pose.position.z(), 0.16, 1e-9);
  EXPECT_EQ(lidar.rate_hz, 40.0);
  EXPECT_EQ(lidar.beam_count, 1081);
  EXPECT_EQ(lidar.angle_min, -2.35);
  EXPECT_EQ(lidar.angle_max, 2.35);
  EXPECT_EQ(lidar.range_min, 0.06);
  EXPECT_EQ(lidar.range_max, 10.0);
  EXPECT_EQ(lidar.noise_mean, 0.001);
  EXPECT_EQ(lidar.noise_stddev, 0.01);
}

TEST(LoadCar, TakesALidarWithoutNoiseAsOneWithoutBias)
{
  const CarDescription car =
    loadCar(smallCarWith("<type>gaussian</type><mean>0.001", "<type>none</type><mean>0.5"), "robot1", "car.urdf");
  EXPECT_EQ(car.lidars.at(0).noise_mean, 0.0);
  EXPECT_EQ(car.lidars.at(0).noise_stddev, 0.0);
}

TEST(LoadCar, TakesEveryKindOfLidar)
{
  const std::pair<std::string, std::string> kinds[] = {
    {"ray", "libgazebo_ros_gpu_laser.so"},
    {"gpu_ray", "libgazebo_ros_gpu_laser.so"},
    {"lidar", "libgazebo_ros_laser.so"},
    {"gpu_lidar", "/opt/lib/libgazebo_ros_laser.so"}};
  for (const auto & [type, library] : kinds) {
    std::string xml = smallCarWith("type=\"ray\"", "type=\"" + type + "\"");
    xml.replace(xml.find("libgazebo_ros_laser.so"), std::string("libgazebo_ros_laser.so").size(), library);
    EXPECT_EQ(load(xml).lidars.size(), 1u) << type;
  }
}

TEST(LoadCar, ContactSensorsWatchTheirCollisionWhetherItsLinkIsKeptOrNot)
{
  const CarDescription car = load(smallCar());
  ASSERT_EQ(car.bumpers.size(), 4u);
  for (const BumperDescription & bumper : car.bumpers) {
    EXPECT_EQ(bumper.topic, bumper.name);
    EXPECT_EQ(bumper.frame, bumper.name);
    EXPECT_EQ(bumper.rate_hz, 50.0);
    ASSERT_EQ(bumper.collision_names.size(), 1u);
    const Solid & solid = solidNamed(car, bumper.collision_names[0]);
    EXPECT_NE(solid.name.find(bumper.name + "_collision"), std::string::npos);
  }
}

TEST(LoadCar, ReadsTheImu)
{
  const CarDescription car = load(smallCar());
  const Imu imu = only<Imu>(car);
  EXPECT_EQ(imu.mount().topic, "imu");
  EXPECT_EQ(imu.mount().frame, "imu");
  EXPECT_EQ(imu.mount().rate_hz, 100.0);
  EXPECT_EQ(imu.noise().yaw_rate_stddev, 0.005);
  EXPECT_EQ(imu.noise().acceleration_stddev, 0.05);
}

std::string withImuPlugin(const std::string & plugin)
{
  std::string xml = smallCarWith("</robot>", plugin + "</robot>");
  const std::size_t sensor = xml.find("<gazebo reference=\"imu\">");
  return xml.erase(sensor, xml.find("</gazebo>", sensor) + std::string("</gazebo>").size() - sensor);
}

const char * const kImuPlugin =
  "<gazebo><plugin name='p' filename='libgazebo_ros_imu.so'><bodyName>imu</bodyName></plugin></gazebo>";

TEST(LoadCar, TakesAnImuPluginOfTheModel)
{
  const std::string plugin =
    "<gazebo><plugin name='old_imu' filename='libgazebo_ros_imu.so'><topicName>imu/data</topicName>"
    "<bodyName>imu</bodyName><updateRate>50</updateRate><gaussianNoise>0.01</gaussianNoise></plugin></gazebo>";
  const CarDescription with_two = load(smallCarWith("</robot>", plugin + "</robot>"));
  EXPECT_TRUE(hasLine(
    with_two.warnings, "test.urdf:250: robot[small_car]/gazebo[11]/plugin[old_imu]: is a second IMU and left out"));
  const CarDescription car = load(withImuPlugin(plugin));
  const Imu imu = only<Imu>(car);
  EXPECT_EQ(imu.mount().topic, "imu/data");
  EXPECT_EQ(imu.mount().frame, "imu");
  EXPECT_EQ(imu.mount().rate_hz, 50.0);
  EXPECT_EQ(imu.noise().yaw_rate_stddev, 0.01);
  EXPECT_TRUE(car.plugins.size() == 1);
}

TEST(LoadCar, TakesAnImuPluginOfHector)
{
  const auto imuWith = [](const std::string & tags) {
    return only<Imu>(load(withImuPlugin(
      "<gazebo><plugin name='hector' filename='libhector_gazebo_ros_imu.so'><updateRate>50.0</updateRate>"
      "<bodyName>imu</bodyName>" +
      tags + "</plugin></gazebo>")));
  };
  const Imu plain = imuWith("");
  EXPECT_EQ(plain.mount().topic, "imu");
  EXPECT_EQ(plain.mount().frame, "imu");
  EXPECT_EQ(plain.mount().rate_hz, 50.0);
  EXPECT_EQ(plain.noise().yaw_rate_stddev, 0.0);
  const Imu noisy = imuWith(
    "<topicName>imu/data</topicName><frameId>base_link</frameId><accelGaussianNoise>0.35 0.4 0.3</accelGaussianNoise>"
    "<rateGaussianNoise>0.005</rateGaussianNoise>");
  EXPECT_EQ(noisy.mount().topic, "imu/data");
  EXPECT_EQ(noisy.mount().frame, "base_link");
  EXPECT_EQ(noisy.noise().yaw_rate_stddev, 0.005);
  EXPECT_EQ(noisy.noise().acceleration_stddev, 0.35);
  EXPECT_THROW(imuWith("<rateGaussianNoise>-1 -1 -1</rateGaussianNoise>"), LoadError);
}

/// The small car without any line that holds one of the texts.
std::string smallCarWithout(const std::vector<std::string> & texts)
{
  std::istringstream lines(smallCar());
  std::string kept;
  for (std::string line; std::getline(lines, line);) {
    const auto isIn = [&line](const std::string & text) { return line.find(text) != std::string::npos; };
    kept += std::any_of(texts.begin(), texts.end(), isIn) ? "" : line + "\n";
  }
  return kept;
}

TEST(LoadCar, MeasuresAtEveryStepWithARateOfZeroOrNone)
{
  std::string zeros = smallCar();
  for (const std::string tag : {"<update_rate>", "<updateRate>"}) {
    for (std::size_t at = zeros.find(tag); at != std::string::npos; at = zeros.find(tag, at + 1)) {
      zeros.replace(at + tag.size(), zeros.find('<', at + 1) - at - tag.size(), "0");
    }
  }
  for (const std::string & xml : {zeros, smallCarWithout({"<update_rate>"})}) {
    const CarDescription car = load(xml);
    EXPECT_EQ(car.lidars.at(0).rate_hz, 0.0);
    EXPECT_EQ(only<Imu>(car).mount().rate_hz, 0.0);
    EXPECT_EQ(car.bumpers.at(0).rate_hz, 0.0);
  }
  EXPECT_EQ(load(zeros).joint_state_rate_hz, 0.0);
  EXPECT_EQ(load(smallCarWith("<updateRate>50</updateRate>", "")).joint_state_rate_hz, 100.0);
  EXPECT_EQ(only<Imu>(load(withImuPlugin(kImuPlugin))).mount().rate_hz, 0.0);
}

TEST(LoadCar, TakesTheDefaultsOfGazeboRosForWhatASensorDoesNotSay)
{
  const CarDescription car = load(smallCarWithout({"<topicName>", "<frameName>laser", "<frameName>b", "TopicName>"}));
  EXPECT_EQ(car.lidars.at(0).topic, "/world");
  EXPECT_EQ(car.lidars.at(0).frame, "world");
  EXPECT_EQ(only<Imu>(car).mount().topic, "imu_data");
  EXPECT_EQ(car.bumpers.at(0).topic, "bumper_states");
  EXPECT_EQ(car.bumpers.at(0).frame, "world");
  EXPECT_TRUE(std::any_of(car.warnings.begin(), car.warnings.end(), [](const std::string & warning) {
    return warning.find("lidar_plugin]: has no <topicName>: taken as '/world', as in gazebo_ros") != std::string::npos;
  }));
  EXPECT_EQ(only<Imu>(load(withImuPlugin(kImuPlugin))).mount().topic, "/default_imu");
  EXPECT_EQ(load(smallCarWith("<samples>1081</samples>", "<samples>1</samples>")).lidars.at(0).beam_count, 1);
}

TEST(LoadCar, TakesOutOfALidarWhatRoundingHasTiltedIt)
{
  const auto mounted = [](const std::string & rpy) {
    const std::string place = "<origin xyz=\"0.27 0 0.11\"";
    return load(smallCarWith(place + "/>", place + " rpy=\"" + rpy + "\"/>")).lidars.at(0).pose;
  };
  EXPECT_NEAR(mounted("3.14 0 0.5").up().z(), -1.0, 1e-12);
  EXPECT_NEAR(mounted("3.14 0 0.5").yaw(), 0.5, 1e-5);
  EXPECT_NEAR(mounted("0 0.001 0.5").up().z(), 1.0, 1e-12);
  EXPECT_NEAR(mounted("0 0.001 0.5").yaw(), 0.5, 1e-5);
}

TEST(LoadCar, TellsJointsApartByAxisAndPlace)
{
  using Role = JointDescription::Role;
  const CarDescription car = load(smallCar());
  const std::vector<std::pair<std::string, Role>> expected{
    {"front_left_steering_joint", Role::kSteeringLeft}, {"front_right_steering_joint", Role::kSteeringRight},
    {"front_left_wheel_joint", Role::kWheelFrontLeft},  {"front_right_wheel_joint", Role::kWheelFrontRight},
    {"rear_left_wheel_joint", Role::kWheelRearLeft},    {"rear_right_wheel_joint", Role::kWheelRearRight}};
  ASSERT_EQ(car.joints.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(car.joints[i].name, expected[i].first);
    EXPECT_EQ(car.joints[i].role, expected[i].second);
  }
  EXPECT_EQ(car.joint_state_rate_hz, 50.0);
  EXPECT_NEAR(car.wheel_radius, 0.05, 1e-12);
  EXPECT_NEAR(car.track_width, 0.2, 1e-9);
}

TEST(LoadCar, KeepsPluginsThatAreNotBuiltInWithTheirTags)
{
  const CarDescription car = load(smallCar());
  ASSERT_EQ(car.plugins.size(), 1u);
  EXPECT_EQ(car.plugins[0].name, "perfect_odometry");
  EXPECT_EQ(car.plugins[0].filename, "libf1tenth_perfect_odometry.so");
  EXPECT_EQ(car.plugins[0].place, "robot[small_car]/gazebo[10]/plugin[perfect_odometry]");
  const std::vector<std::pair<std::string, std::string>> parameters{
    {"updateRate", "200"}, {"robotBaseFrame", "base_footprint"}};
  EXPECT_EQ(car.plugins[0].parameters, parameters);
}

TEST(LoadCar, KeepsNestedTagsOfPluginsByTheirPaths)
{
  const CarDescription car = load(smallCarWith(
    "</robot>", "<gazebo><plugin name='p' filename='libp.so'><a>1</a><b><c>two</c></b></plugin></gazebo></robot>"));
  ASSERT_EQ(car.plugins.size(), 2u);
  const std::vector<std::pair<std::string, std::string>> parameters{{"a", "1"}, {"b", ""}, {"b/c", "two"}};
  EXPECT_EQ(car.plugins[1].parameters, parameters);
}

TEST(LoadCarWarnings, NamePluginsWithoutLibrary)
{
  const CarDescription car = load(smallCarWith("</robot>", "<gazebo><plugin name='mine'/></gazebo></robot>"));
  EXPECT_EQ(car.plugins.size(), 1u);
  EXPECT_TRUE(hasLine(
    car.warnings,
    "test.urdf:250: robot[small_car]/gazebo[11]/plugin[mine]: has no attribute 'filename' and is left out"));
}

TEST(LoadCar, FrameIdsHaveNoSlashInFront)
{
  EXPECT_EQ(load(smallCarWith("<frameName>laser", "<frameName>robot1/laser")).lidars[0].frame, "robot1/laser");
  EXPECT_EQ(load(smallCarWith("<frameName>laser", "<frameName>/laser")).lidars[0].frame, "laser");
}

TEST(LoadCar, BaseFootprintNeedNotBeTheRoot)
{
  std::string xml = smallCarWith("<parent link=\"base_footprint\"/>", "<parent link=\"base_link\"/>");
  xml.replace(xml.find("<child link=\"base_link\"/>"), 25, "<child link=\"base_footprint\"/>");
  xml.replace(xml.find("xyz=\"0 0 0.05\""), 14, "xyz=\"0 0 -0.05\"");
  const CarDescription car = load(xml);
  EXPECT_NEAR(car.lidars.at(0).pose.position.z(), 0.16, 1e-9);
  EXPECT_NEAR(solidNamed(car, "robot1::rear_left_wheel::rear_left_wheel_collision").pose.position.z(), 0.05, 1e-9);
}

TEST(LoadCar, TakesAnSdfModel)
{
  const CarDescription car = load(
    "<sdf version='1.6'><model name='m'><link name='base_footprint'><collision name='c'><pose>0.1 0 0.1 0 0 0</pose>"
    "<geometry><box><size>0.4 0.2 0.1</size></box></geometry></collision></link></model></sdf>");
  EXPECT_EQ(car.links, std::vector<std::string>{"base_footprint"});
  EXPECT_EQ(car.solids.at(0).name, "robot1::base_footprint::c");
  EXPECT_TRUE(car.joints.empty());
}

TEST(LoadCarWarnings, NameWheelsThatTurnAboutAnotherAxisAndWhatSteersThem)
{
  const std::string front = "joint 'front_left_";
  const std::string end =
    "_joint' is left out: neither a wheel (about the y axis of the car, without limits, on the ground) nor a "
    "steering joint (about z, with a wheel on it)";
  const CarDescription car = load(smallCarWith("<axis xyz=\"0 1 0\"/>", ""));
  EXPECT_TRUE(hasLine(
    car.warnings, "test.urdf:28: robot[small_car]/joint[front_left_wheel_joint] and 1 more: " + front + "wheel" + end));
  EXPECT_TRUE(hasLine(
    car.warnings,
    "test.urdf:18: robot[small_car]/joint[front_left_steering_joint] and 1 more: " + front + "steering" + end));
}

TEST(LoadCarWarnings, NameWhatUrdfDoesNotKnow)
{
  const std::string box = "<geometry><box size=\"0.02 0.2 0.06\"/></geometry>";
  const std::tuple<std::string, std::string, std::string> misspelt[]{
    {"<orgin xyz='5 0 0'/>" + box, "/orgin", "is not an element of URDF and left out"},
    {"<origin xyz='0 0 0' pry='0 0 1'/>" + box, "/origin", "attribute 'pry' is none of URDF and left out"},
    {"<geometry><box size='1 1 1'><scale>0.001 0.001 0.001</scale></box></geometry>", "/geometry/box/scale",
     "is not an element of URDF and left out"},
    {"<geometry><box size='1 1 1' scales='0.001 0.001 0.001'/></geometry>", "/geometry/box",
     "attribute 'scales' is none of URDF and left out"}};
  for (const auto & [inside, place, message] : misspelt) {
    const CarDescription car = load(smallCarWith(box, inside));
    EXPECT_NE(car.warnings.at(0).find("/link[bumper_front]/collision" + place + ": " + message), std::string::npos)
      << car.warnings[0];
  }
  EXPECT_EQ(
    load(
      smallCarWith(
        "<link name=\"base_footprint\"/>", "<link name='base_footprint'><visual x='y'><z/></visual><other:w/></link>"))
      .warnings.size(),
    1u);
}

TEST(LoadCarWarnings, NameSensorsWithoutRosPlugin)
{
  const CarDescription car = load(smallCarWith("libgazebo_ros_laser.so", "libother.so"));
  EXPECT_TRUE(car.lidars.empty());
  EXPECT_TRUE(hasLine(
    car.warnings,
    "test.urdf:195: robot[small_car]/gazebo[laser]/sensor[lidar]: has no <plugin> libgazebo_ros_laser.so or "
    "libgazebo_ros_gpu_laser.so or libgazebo_ros_range.so to publish it and is left out"));
}

TEST(LoadCarWarnings, NameSensorsThatAreNotSimulated)
{
  const std::string sonar =
    "<gazebo reference=\"base_link\"><sensor name=\"height\" type=\"altimeter\"/></gazebo></robot>";
  EXPECT_TRUE(hasLine(
    load(smallCarWith("</robot>", sonar)).warnings,
    "test.urdf:250: robot[small_car]/gazebo[base_link]/sensor[height]: a sensor of type altimeter is left out: not "
    "simulated"));
}

TEST(LoadCarWarnings, NameSensorsOfAnUnknownType)
{
  const std::string crystal =
    "<gazebo reference=\"base_link\"><sensor name=\"ball\" type=\"crystal\"/></gazebo></robot>";
  EXPECT_TRUE(hasLine(
    load(smallCarWith("</robot>", crystal)).warnings,
    "test.urdf:250: robot[small_car]/gazebo[base_link]/sensor[ball]: is no type of sensor of SDF and left out"));
}

TEST(LoadCarWarnings, NameFurtherLayersOfALidar)
{
  const CarDescription car = load(smallCarWith(
    "</horizontal>",
    "</horizontal><vertical><samples>4</samples><min_angle>-0.1</min_angle><max_angle>0.1</max_angle></vertical>"));
  EXPECT_TRUE(hasLine(
    car.warnings,
    "test.urdf:195: robot[small_car]/gazebo[laser]/sensor[lidar]: <vertical> is left out: a lidar has one level "
    "layer"));
}

TEST(LoadCar, PrintsNothing)
{
  testing::internal::CaptureStderr();
  load(smallCar());
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}
}  // namespace
}  // namespace f1tenth_sim2d
