#include <gtest/gtest.h>

#include "f1tenth_sim2d/loaders.h"
#include "small_car.h"
#include "temp_folder.h"

namespace f1tenth_sim2d
{
namespace
{
struct BadCar
{
  const char * name;
  std::string xml;
  std::string message;
};

void PrintTo(const BadCar & bad, std::ostream * out)
{
  *out << bad.name;
}

const std::string kLidar = "test.urdf: robot[small_car]/gazebo[laser]/sensor[lidar]";
const std::string kPublisher = "test.urdf: robot[small_car]/gazebo[9]/plugin[joint_state_publisher]";

std::string robot(const std::string & inside)
{
  return "<robot name='r'>" + inside + "</robot>";
}

std::vector<BadCar> badCars()
{
  return {
    {"Empty", "", "test.urdf: malformed XML: EMPTY_DOCUMENT"},
    {"Malformed", "<robot name='r'>\n<link name='l'>\n</robot>",
     "test.urdf: line 2: malformed XML: MISMATCHED_ELEMENT, XMLElement name=link"},
    {"NotARobot", "<car/>", "test.urdf: car: is no robot description, allowed are <robot> (URDF) and <sdf>"},
    {"NoLinks", robot(""), "test.urdf: robot[r]: has no <link>"},
    {"LinkTwice", robot("<link name='base_footprint'/><link name='base_footprint'/>"),
     "test.urdf: robot[r]/link[base_footprint]: this name is taken; names are unique among the links of a robot"},
    {"TwoRoots", robot("<link name='a'/><link name='b'/>"),
     "test.urdf: robot[r]: has two links without a parent, 'a' and 'b'; allowed is one"},
    {"XacroThatIsNotExpanded",
     "<robot name='r' xmlns:xacro='x'><link name='a'/><xacro:wheel name='b'/><joint name='j' type='fixed'><parent "
     "link='a'/><child link='b'/></joint></robot>",
     "test.urdf: robot[r]/joint[j]: names the link 'b', which is not there: the description holds <xacro:…> tags; "
     "expand it with xacro first"},
    {"XacroInALink", robot("<link name='a'><xacro:inertia m='1'/></link>"),
     "test.urdf: robot[r]/link[a]/xacro:inertia: is not an element of URDF: the description holds <xacro:…> tags; "
     "expand it with xacro first"},
    {"NothingThatTouches",
     robot("<link name='body'><inertial><mass value='2'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/>"
           "</inertial><visual><geometry><box size='1 1 1'/></geometry></visual></link>"),
     "test.urdf: robot[r]: has nothing that could touch anything: no <collision> on a link with mass"},
    {"NothingAtAll", robot("<link name='body'><visual><geometry><box size='1 1 1'/></geometry></visual></link>"),
     "test.urdf: robot[r]: has nothing that could touch anything: no <collision> on a link with mass"},
    {"BoxOfTwoNumbers", smallCarWith("<box size=\"0.02 0.2 0.06\"/>", "<box size=\"1 1\"/>"),
     "test.urdf: robot[small_car]/link[bumper_front]/collision/geometry/box: attribute 'size' is '1 1', allowed are "
     "three "
     "numbers"},
    {"SdfWithoutModel", "<sdf version='1.6'><world name='w'/></sdf>", "test.urdf: holds no <model>"},
    {"PlaneInACar",
     "<sdf version='1.6'><model name='m'><link name='base_footprint'><collision name='c'><geometry><plane><normal>"
     "0 0 1</normal><size>1 1</size></plane></geometry></collision></link></model></sdf>",
     "test.urdf: model[m]/link[base_footprint]: has the collision robot1::base_footprint::c, a <plane>: it has no end "
     "and "
     "cannot be part of a car"},
    {"ZeroSize", smallCarWith("<box size=\"0.02 0.2 0.06\"/>", "<box size=\"0.02 0 0.06\"/>"),
     "test.urdf: robot[small_car]/link[bumper_front]/collision/geometry/box: attribute 'size' is 0, allowed are finite "
     "numbers greater than 0"},
    {"MeshInACar", smallCarWith("<box size=\"0.02 0.2 0.06\"/>", "<mesh filename=\"package://p/m.stl\"/>"),
     "test.urdf: robot[small_car]/link[bumper_front]/collision/geometry/mesh: <uri> is "
     "package://p/m.stl, which is not found; searched: nothing, since GAZEBO_MODEL_PATH, GAZEBO_RESOURCE_PATH and "
     "ROS_PACKAGE_PATH are "
     "empty"},
    {"WheelWithoutMass",
     smallCarWith(
       "<link name=\"rear_left_wheel\">\n    <inertial><mass value=\"0.1\"/>",
       "<link name=\"rear_left_wheel\">\n    <inertial><mass value=\"0\"/>"),
     "test.urdf: robot[small_car]/link[rear_left_wheel]: has a <collision>, but no mass, so that Gazebo leaves it out; "
     "needed is an "
     "<inertial> with a mass above 0"},
    {"NegativeMass", smallCarWith("<mass value=\"3.0\"/>", "<mass value=\"-3\"/>"),
     "test.urdf: robot[small_car]/link[base_footprint]: the mass (kg) is -2.8, allowed are finite numbers from 0"},
    {"MassThatIsNoNumber", smallCarWith("<mass value=\"3.0\"/>", "<mass value=\"nan\"/>"),
     "test.urdf: robot[small_car]/link[base_footprint]: the mass (kg) is nan, allowed are finite numbers from 0"},
    {"InertiaThatIsNoNumber", smallCarWith("ixx=\"1e-3\"", "ixx=\"nan\""),
     "test.urdf: robot[small_car]/link[base_footprint]: the moments of inertia are not finite"},
    {"WheelsWithoutFriction",
     smallCarWith(
       "</robot>",
       "<gazebo reference=\"rear_left_wheel\"><mu1>0</mu1></gazebo>"
       "<gazebo reference=\"rear_right_wheel\"><mu1>0</mu1></gazebo>"
       "<gazebo reference=\"front_left_wheel\"><mu1>0</mu1></gazebo>"
       "<gazebo reference=\"front_right_wheel\"><mu1>0</mu1></gazebo></robot>"),
     "test.urdf: robot[small_car]: the friction (mu1) of all wheels is 0, allowed are numbers greater than 0"},
    {"TiltedLidar", smallCarWith("<origin xyz=\"0.27 0 0.11\"/>", "<origin xyz=\"0.27 0 0.11\" rpy=\"0 0.1 0\"/>"),
     kLidar + ": is tilted; a lidar has to be level, upright or upside down"},
    {"TopicThatIsNoName", smallCarWith("<topicName>scan</topicName>", "<topicName>my-scan!</topicName>"),
     kLidar +
       "/plugin[lidar_plugin]: topic 'my-scan!' is no ROS name; allowed are letters, digits, _ and /, beginning with a "
       "letter or /"},
    {"FrameThatIsNoName", smallCarWith("<frameName>laser</frameName>", "<frameName>my laser</frameName>"),
     kLidar + "/plugin[lidar_plugin]: frame 'my laser' is no frame id; allowed are letters, digits, _, /, ., - and :"},
    {"EmptyFrameName", smallCarWith("<frameName>laser</frameName>", "<frameName> </frameName>"),
     kLidar + "/plugin[lidar_plugin]: <frameName> is empty"},
    {"RateOfNoClock", smallCarWith("<update_rate>40</update_rate>", "<update_rate>1e300</update_rate>"),
     kLidar + ": <update_rate> is 1e+300, allowed is at most 1e+06 Hz"},
    {"RateOfNoBumper", smallCarWith("<update_rate>50</update_rate>", "<update_rate>1e7</update_rate>"),
     "test.urdf: robot[small_car]/gazebo[bumper_front]/sensor[bumper_front]: <update_rate> is 1e+07, allowed is at "
     "most 1e+06 Hz"},
    {"RateBelowZero", smallCarWith("<update_rate>50</update_rate>", "<update_rate>-1</update_rate>"),
     "test.urdf: robot[small_car]/gazebo[bumper_front]/sensor[bumper_front]: <update_rate> is -1, allowed are finite "
     "numbers from 0"},
    {"NoBeam", smallCarWith("<samples>1081</samples>", "<samples>0</samples>"),
     kLidar + ": has 0 <samples>, allowed are 1 to 100000"},
    {"FarTooManyBeams", smallCarWith("<samples>1081</samples>", "<samples>4000000000</samples>"),
     kLidar + ": has 4e+09 <samples>, allowed are 1 to 100000"},
    {"ManyTurns", smallCarWith("<max_angle>2.35</max_angle>", "<max_angle>1e9</max_angle>"),
     kLidar + ": <min_angle> has to be less than <max_angle>, both within two turns"},
    {"RangeBeyondTheWorld", smallCarWith("<max>10</max>", "<max>1e300</max>"),
     kLidar + ": <range/max> is 1e+300, allowed is at most 100000 m"},
    {"BiasThatIsNoNumber", smallCarWith("<mean>0.001</mean>", "<mean>nan</mean>"),
     kLidar + ": <noise/mean> is nan, allowed are numbers from -10 to 10, the greatest range (m)"},
    {"BiasBeyondTheRange", smallCarWith("<mean>0.001</mean>", "<mean>-1e6</mean>"),
     kLidar + ": <noise/mean> is -1e+06, allowed are numbers from -10 to 10, the greatest range (m)"},
    {"AnglesSwapped", smallCarWith("<max_angle>2.35</max_angle>", "<max_angle>-2.5</max_angle>"),
     kLidar + ": <min_angle> has to be less than <max_angle>, both within two turns"},
    {"NegativeRange", smallCarWith("<min>0.06</min>", "<min>-1</min>"),
     kLidar + ": <range/min> is -1, allowed are finite numbers from 0"},
    {"InfiniteRange", smallCarWith("<max>10</max>", "<max>inf</max>"),
     kLidar + ": <range/max> is inf, allowed are finite numbers greater than 0"},
    {"RangeSwapped", smallCarWith("<max>10</max>", "<max>0.01</max>"),
     kLidar + ": <range> has a <min> that is not less than its <max>"},
    {"NegativeNoise", smallCarWith("<stddev>0.01</stddev>", "<stddev>-1</stddev>"),
     kLidar + "/ray/noise: <stddev> is -1, allowed are finite numbers from 0"},
    {"UnknownCollision", smallCarWith("<collision>bumper_left_collision", "<collision>nothing"),
     "test.urdf: robot[small_car]/gazebo[bumper_left]/sensor[bumper_left]: there is no <collision> 'nothing'; the car "
     "has base_footprint::base_footprint_fixed_joint_lump__base_link_collision, "
     "base_footprint::base_footprint_fixed_joint_lump__bumper_left_collision_1, "
     "base_footprint::base_footprint_fixed_joint_lump__bumper_right_collision_2, bumper_front::bumper_front_collision, "
     "bumper_rear::bumper_rear_collision, front_left_wheel::front_left_wheel_collision, "
     "front_right_wheel::front_right_wheel_collision, rear_left_wheel::rear_left_wheel_collision, "
     "rear_right_wheel::rear_right_wheel_collision"},
    {"ContactWithoutCollision", smallCarWith("<contact><collision>bumper_left_collision</collision></contact>", ""),
     "test.urdf: robot[small_car]/gazebo[bumper_left]/sensor[bumper_left]: has no <contact> with a <collision>"},
    {"SensorNameTwice", smallCarWith("<sensor name=\"imu\"", "<sensor name=\"bumper_front\""),
     "test.urdf: robot[small_car]/gazebo[bumper_front]/sensor[bumper_front]: this name is taken; names are unique "
     "among "
     "the sensors of a car"},
    {"UnknownJoint", smallCarWith("<jointName>front_left_steering_joint", "<jointName>nose_joint"),
     kPublisher + ": <jointName> names 'nose_joint', which is no joint that moves"},
    {"JointTwice", smallCarWith("<jointName>front_left_steering_joint,", "<jointName>front_right_steering_joint,"),
     kPublisher + ": <jointName> names 'front_right_steering_joint' twice"},
    {"TwoJointsAtOneCorner", smallCarWith("xyz=\"0.32 -0.1 0\"", "xyz=\"0.32 0.2 0\""),
     kPublisher + ": <jointName> names both 'front_left_steering_joint' and 'front_right_steering_joint' at the same "
                  "corner of the car"},
  };
}

/// A car with a drive plugin and its tags.
std::string driven(const std::string & tags)
{
  return smallCarWith(
    "</robot>",
    "<gazebo><plugin name='d' filename='libgazebo_ros_ackermann_drive.so'>" + tags + "</plugin></gazebo></robot>");
}

std::vector<BadCar> carsWithBadTopics()
{
  const std::string drive = "test.urdf: robot[small_car]/gazebo[11]/plugin[d]";
  const std::string allowed =
    "' is no topic; allowed are names with a / in front or between them, neither doubled nor at the end";
  return {
    {"RemappedToNothing", driven("<ros><remapping>cmd_vel:=</remapping></ros>"),
     drive + "/ros/remapping: is 'cmd_vel:=', allowed is FROM:=TO"},
    {"TopicOfTheCarsNamespace", driven("<commandTopic>/robot1/</commandTopic>"), drive + ": '/robot1/" + allowed},
    {"TopicOfASlash", driven("<commandTopic>/</commandTopic>"), drive + ": '/" + allowed},
    {"TopicWithADoubledSlash", driven("<odometryTopic>a//odom</odometryTopic>"), drive + ": 'a//odom" + allowed},
    {"NamespaceWithADoubledSlash", driven("<ros><namespace>/a//</namespace></ros>"),
     drive + ": '/a//cmd_vel" + allowed},
  };
}

std::vector<BadCar> carsWithBadPoseSensors()
{
  const auto car = [](const std::string & tags) {
    return smallCarWith(
      "</robot>",
      "<gazebo><plugin name='p' filename='libgazebo_ros_p3d.so'><topicName>t</topicName><bodyName>imu</bodyName>" +
        tags + "</plugin></gazebo></robot>");
  };
  const std::string plugin = "test.urdf: robot[small_car]/gazebo[11]/plugin[p]";
  const std::string far = plugin + "/xyzOffset: is not within 100000 m of the origin";
  return {
    {"OffsetThatIsNoNumber", car("<xyzOffset>nan 0 0</xyzOffset>"), far},
    {"OffsetOutOfThisWorld", car("<xyzOffset>0 0 1e300</xyzOffset>"), far},
    {"OffsetOfAnEndlessTurn", car("<rpyOffset>0 inf 0</rpyOffset>"),
     plugin + "/rpyOffset: is '0 inf 0', allowed are finite numbers"},
  };
}

class LoadCarErrors : public testing::TestWithParam<BadCar>
{
};

TEST_P(LoadCarErrors, NameSourcePlaceAndReason)
{
  EXPECT_EQ(loadErrorOf([] { loadCar(GetParam().xml, "robot1", "test.urdf"); }), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
  BadCars, LoadCarErrors, testing::ValuesIn(badCars()),
  [](const testing::TestParamInfo<BadCar> & bad) { return bad.param.name; });
INSTANTIATE_TEST_SUITE_P(
  BadTopics, LoadCarErrors, testing::ValuesIn(carsWithBadTopics()),
  [](const testing::TestParamInfo<BadCar> & bad) { return bad.param.name; });

INSTANTIATE_TEST_SUITE_P(
  BadPoseSensors, LoadCarErrors, testing::ValuesIn(carsWithBadPoseSensors()),
  [](const testing::TestParamInfo<BadCar> & bad) { return bad.param.name; });
}  // namespace
}  // namespace f1tenth_sim2d
