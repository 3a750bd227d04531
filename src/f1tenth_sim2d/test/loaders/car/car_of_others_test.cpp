#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

#include "core/components/imu/imu.h"
#include "f1tenth_sim2d/loaders.h"
#include "only.h"
#include "temp_folder.h"

namespace f1tenth_sim2d
{
namespace
{
/// A car written for Gazebo and ros_control, not for this simulator.
class CarOfOthers : public testing::Test
{
protected:
  static std::string racecar()
  {
    std::ostringstream text;
    text << std::ifstream(F1TENTH_SIM2D_TEST_DATA "/racecar.urdf").rdbuf();
    return text.str();
  }

  static std::string changed(const std::string & from, const std::string & to)
  {
    std::string xml = racecar();
    EXPECT_NE(xml.find(from), std::string::npos) << from;
    for (std::size_t at = xml.find(from); at != std::string::npos; at = xml.find(from, at + to.size())) {
      xml.replace(at, from.size(), to);
    }
    return xml;
  }

  static std::string withPlugin(const std::string & library, const std::string & tags)
  {
    const std::string drive = R"(<plugin name="drive" filename="libgazebo_ros_skid_steer_drive.so">)";
    return changed(drive, "<plugin name='mine' filename='" + library + "'>" + tags + "</plugin>" + drive);
  }

  static CarDescription load(const std::string & xml) { return loadCar(xml, "robot1", "racecar.urdf"); }
  static std::string error(const std::string & xml)
  {
    return loadErrorOf([&xml] { load(xml); });
  }
};

TEST_F(CarOfOthers, HasItsFrameBelowTheRearAxle)
{
  const CarDescription car = load(racecar());
  EXPECT_EQ(car.base_frame, "base_link");
  EXPECT_NEAR(car.base_frame_pose.position.x(), 0.17, 1e-9);
  EXPECT_NEAR(car.base_frame_pose.position.z(), 0.05, 1e-9);
  EXPECT_EQ(car.model_pose, car.base_frame_pose);
  EXPECT_NEAR(car.link_poses.at("laser").position.x(), 0.37, 1e-9);
  EXPECT_NEAR(car.lidars.at(0).pose.position.x(), 0.37, 1e-9);
  EXPECT_NEAR(car.lidars.at(0).pose.position.z(), 0.15, 1e-9);
  EXPECT_NEAR(car.solids.at(0).pose.position.x(), 0.17, 1e-9);
}

TEST_F(CarOfOthers, HasAMechanismWithDirectionsAndLimits)
{
  using Role = JointDescription::Role;
  const CarDescription car = load(racecar());
  const std::vector<std::pair<std::string, Role>> expected{
    {"left_front_wheel_joint", Role::kWheelFrontLeft},  {"right_front_wheel_joint", Role::kWheelFrontRight},
    {"left_rear_wheel_joint", Role::kWheelRearLeft},    {"right_rear_wheel_joint", Role::kWheelRearRight},
    {"left_steering_hinge_joint", Role::kSteeringLeft}, {"right_steering_hinge_joint", Role::kSteeringRight}};
  ASSERT_EQ(car.mechanism.size(), expected.size());  // without the mast, which carries no wheel
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(car.mechanism[i].name, expected[i].first);
    EXPECT_EQ(car.mechanism[i].role, expected[i].second);
    EXPECT_EQ(car.mechanism[i].direction, i % 2 == 0 ? 1.0 : -1.0) << car.mechanism[i].name;
  }
  EXPECT_EQ(car.mechanism[4].lower, -0.5);
  EXPECT_EQ(car.mechanism[4].upper, 0.6);
  EXPECT_EQ(car.mechanism[0].upper, std::numeric_limits<double>::infinity());
  EXPECT_EQ(car.mechanism[0].velocity_max, 120.0);
  EXPECT_EQ(car.mechanism[0].effort_max, 0.3);
  EXPECT_NEAR(car.wheel_radius, 0.05, 1e-12);
  EXPECT_NEAR(car.track_width, 0.2, 1e-9);
}

TEST_F(CarOfOthers, KeepsJointsInTheMiddleBesideThoseOfItsWheels)
{
  using Role = JointDescription::Role;
  const std::string inertial =
    R"(<inertial><mass value="1e-3"/><inertia ixx="1e-6" iyy="1e-6" izz="1e-6" ixy="0" ixz="0" iyz="0"/></inertial>)";
  std::string model_of_the_car = R"(
    <joint name="front_steer_joint" type="revolute">
      <parent link="chassis"/><child link="front_steer"/><origin xyz="0.16 0 0"/><axis xyz="0 0 1"/>
      <limit lower="-0.5" upper="0.5" effort="10" velocity="5"/>
    </joint>
    <joint name="front_wheel_joint" type="continuous">
      <parent link="front_steer"/><child link="front_wheel"/><axis xyz="0 1 0"/>
    </joint>
    <joint name="rear_wheel_joint" type="continuous">
      <parent link="chassis"/><child link="rear_wheel"/><origin xyz="-0.17 0 0"/><axis xyz="0 1 0"/>
    </joint>)";
  for (const char * const link : {"front_steer", "front_wheel", "rear_wheel"}) {
    model_of_the_car += "<link name='" + std::string(link) + "'>" + inertial + "</link>";
  }
  const CarDescription car = load(changed("</robot>", model_of_the_car + "</robot>"));
  ASSERT_EQ(car.mechanism.size(), 9u);
  EXPECT_EQ(car.mechanism[6].role, Role::kWheelFrontMiddle);
  EXPECT_EQ(car.mechanism[7].role, Role::kWheelRearMiddle);
  EXPECT_EQ(car.mechanism[8].role, Role::kSteeringMiddle);
  EXPECT_TRUE(car.mechanism[8].steers());
  EXPECT_EQ(car.mechanism[8].name, "front_steer_joint");
  EXPECT_NEAR(car.track_width, 0.2, 1e-9);
  EXPECT_NEAR(car.parameters.wheelbase(), 0.33, 1e-9);
}

/// A joint and a link with a round collision.
std::string joint(
  const std::string & name, const std::string & parent, const std::string & place, const std::string & axis,
  const std::string & limits)
{
  const std::string type = limits.empty() ? "continuous" : "revolute";
  return "<link name='" + name +
         "'><inertial><mass value='2e-6'/><inertia ixx='1e-9' iyy='1e-9' izz='1e-9' ixy='0' ixz='0' "
         "iyz='0'/></inertial>"
         "<collision><geometry><sphere radius='0.01'/></geometry></collision></link><joint name='" +
         name + "_joint' type='" + type + "'><parent link='" + parent + "'/><child link='" + name + "'/><origin xyz='" +
         place + "'/><axis xyz='" + axis + "'/><limit effort='1' velocity='1' " + limits + "/></joint>";
}

TEST_F(CarOfOthers, DrivesAsBeforeWithJointsThatAreNoWheels)
{
  const std::string half_a_turn = "lower='-1.5' upper='1.5'";
  const std::string lever = joint("tilt", "chassis", "0 0 -0.04", "0 1 0", half_a_turn);
  const std::string drum = joint("tilt", "chassis", "0 0 0.3", "0 1 0", "");
  const std::string camera =
    joint("pan", "chassis", "0.1 0 0.1", "0 0 1", half_a_turn) + joint("tilt", "pan", "0 0 0.1", "0 1 0", half_a_turn);
  const VehicleParameters plain = load(racecar()).parameters;
  for (const std::string & added : {lever, drum, camera}) {
    const CarDescription car = load(changed("</robot>", added + "</robot>"));
    EXPECT_EQ(car.mechanism.size(), 6u);
    EXPECT_NEAR(car.parameters.v_max, plain.v_max, 1e-6);
    EXPECT_NEAR(car.parameters.a_max, plain.a_max, 1e-3);
    EXPECT_NEAR(car.parameters.steering_rate_max, plain.steering_rate_max, 1e-6);
    EXPECT_NEAR(car.parameters.wheelbase(), plain.wheelbase(), 1e-6);
    EXPECT_TRUE(std::any_of(car.warnings.begin(), car.warnings.end(), [](const std::string & warning) {
      return warning.find("joint 'tilt_joint' is left out: neither a wheel") != std::string::npos;
    }));
  }
}

TEST_F(CarOfOthers, HasTheDynamicsOfItsDescription)
{
  const VehicleParameters p = load(racecar()).parameters;
  // Chassis 4 kg at 0.16 m, wheels and hinges 0.6 kg at 0.33 m, rear wheels 0.4 kg at 0, mast 0.05 kg at 0.17 m.
  EXPECT_NEAR(p.m, 5.05, 1e-9);
  EXPECT_NEAR(p.l_r, (4.0 * 0.16 + 0.6 * 0.33 + 0.05 * 0.17) / 5.05, 1e-9);
  EXPECT_NEAR(p.wheelbase(), 0.33, 1e-9);
  EXPECT_NEAR(p.h, (4.0 * 0.07 + 1.0 * 0.05 + 0.05 * 0.15) / 5.05, 1e-9);
  const double spread = 4.0 * std::pow(0.16 - p.l_r, 2) + 0.6 * std::pow(0.33 - p.l_r, 2) + 0.4 * std::pow(p.l_r, 2) +
                        0.05 * std::pow(0.17 - p.l_r, 2) + 1.0 * 0.1 * 0.1;
  EXPECT_NEAR(p.I_z, 0.035 + 7e-4 + spread, 1e-9);
  EXPECT_EQ(p.mu, 0.8);
  EXPECT_EQ(p.steering_max, 0.5);
  EXPECT_EQ(p.steering_rate_max, 5.0);
  EXPECT_NEAR(p.v_max, 6.0, 1e-9);
  EXPECT_EQ(p.v_min, -5.0);
  EXPECT_NEAR(p.a_max, 4.0 * 0.3 / 0.05 / 5.05, 1e-9);
  EXPECT_EQ(p.C_Sf, VehicleParameters().C_Sf);
}

TEST_F(CarOfOthers, IsRefusedNothingWhereADescriptionSaysTooMuch)
{
  const CarDescription slippery = load(changed("<mu1>0.8</mu1>", "<mu1>1000</mu1>"));
  EXPECT_EQ(slippery.parameters.mu, 0.9);
  const CarDescription glued = load(changed("<mu1>0.9</mu1>", "<mu1>5</mu1>"));
  EXPECT_EQ(glued.parameters.mu, 0.8);
  const CarDescription on_a_caster = load(changed("<mu1>0.8</mu1>", "<mu1>0</mu1>"));
  EXPECT_EQ(on_a_caster.parameters.mu, 0.9);
  const CarDescription nose_heavy = load(changed("-0.01 0 0.02", "0.3 0 0.02"));
  EXPECT_NEAR(nose_heavy.parameters.l_r, 0.33 * 0.17145 / 0.3302, 1e-9);
  EXPECT_EQ(
    nose_heavy.warnings.back(),
    "racecar.urdf:4: robot[racecar]: the centre of mass is not between the axles: taken where the F1/10 car has it");
}

TEST_F(CarOfOthers, WithEndlessFrictionHasThatOfATyre)
{
  const CarDescription car = load(std::regex_replace(racecar(), std::regex("<mu1>[^<]*"), "<mu1>1e10"));
  EXPECT_EQ(car.parameters.mu, 2.0);
  EXPECT_EQ(
    car.warnings.back(),
    "racecar.urdf:4: robot[racecar]: friction of the wheels beyond 2 is taken as 2: no tyre has more");
}

TEST_F(CarOfOthers, HasTopicsInTheNamespaceOfTheDescription)
{
  const CarDescription car = load(racecar());
  EXPECT_EQ(car.lidars.at(0).topic, "/racecar/scan");
  EXPECT_EQ(only<Imu>(car).mount().topic, "/imu/data");
  EXPECT_EQ(car.drive->command_topic, "/other/motor");
  EXPECT_EQ(car.drive->odometry_topic, "/other/odom");
}

TEST_F(CarOfOthers, CalledAsTheNamespaceOfTheDescriptionHasRelativeTopics)
{
  const CarDescription car = loadCar(racecar(), "racecar", "racecar.urdf");
  EXPECT_EQ(car.lidars.at(0).topic, "scan");
  EXPECT_EQ(car.ros_control->ros_namespace, "");
  EXPECT_EQ(loadCar(changed("<topicName>scan", "<topicName>/racecar/scan"), "racecar", "x").lidars.at(0).topic, "scan");
}

TEST_F(CarOfOthers, InTheRootNamespaceHasGlobalTopics)
{
  EXPECT_EQ(load(changed("<robotNamespace>/racecar<", "<robotNamespace>/<")).lidars.at(0).topic, "/scan");
}

TEST_F(CarOfOthers, IsMovedByRosControl)
{
  const CarDescription car = load(racecar());
  ASSERT_TRUE(car.ros_control.has_value());
  EXPECT_EQ(car.ros_control->ros_namespace, "/racecar");
  EXPECT_EQ(car.ros_control->control_period_sec, 0.002);
}

TEST_F(CarOfOthers, WarnsOfTransmissionsThatMoveNothingHere)
{
  const CarDescription mast = load(changed("<joint name=\"left_rear_wheel_joint\"/>", "<joint name=\"mast_joint\"/>"));
  EXPECT_EQ(
    mast.warnings.front(),
    "racecar.urdf:133: robot[racecar]/joint[mast_joint] and 1 more: joint 'mast_joint' is left out: neither a wheel "
    "(about the y axis of the car, without limits, on the ground) nor a steering joint (about z, with a wheel on it)");
  const CarDescription odd = load(changed("SimpleTransmission", "DifferentialTransmission"));
  EXPECT_EQ(
    odd.warnings.at(1),
    "racecar.urdf:109: robot[racecar]/transmission[left_steering_hinge_transmission] and 3 more: a transmission of "
    "type "
    "'transmission_interface/DifferentialTransmission' is left out: simulated is SimpleTransmission");
}

TEST_F(CarOfOthers, PublishesThePoseOfALinkThatAFixedJointHolds)
{
  const PoseSensorDescription sensor = load(racecar()).pose_sensors.at(0);
  EXPECT_EQ(sensor.topic, "ground_truth");
  EXPECT_EQ(sensor.frame, "map");
  EXPECT_EQ(sensor.link, "imu_link");
  EXPECT_NEAR(sensor.pose.position.x(), 0.22, 1e-9);
  EXPECT_NEAR(sensor.pose.position.z(), 0.09, 1e-9);
  EXPECT_EQ(sensor.xyz_offset, Eigen::Vector3d(1, 2, 0));
  EXPECT_EQ(sensor.rpy_offset, Eigen::Vector3d::Zero());
  EXPECT_EQ(sensor.rate_hz, 60.0);
  EXPECT_EQ(sensor.noise_stddev, 0.01);
}

TEST_F(CarOfOthers, RefusesAPoseOfNoLinkOrWithABrokenOffset)
{
  const std::string place = "racecar.urdf: robot[racecar]/gazebo[5]/plugin[ground_truth]: ";
  EXPECT_EQ(
    error(
      changed("<bodyName>imu_link</bodyName>\n      <topicName>g", "<bodyName>nose</bodyName>\n      <topicName>g")),
    place + "<bodyName> is 'nose', which is no link of the car");
  EXPECT_EQ(error(changed(">1 2 0<", ">1 2<")), place + "<xyzOffset> is '1 2', allowed are three numbers");
}

TEST_F(CarOfOthers, DrivesByThePluginsOfGazeboRos)
{
  using Kind = DriveDescription::Kind;
  const DriveDescription skid = *load(racecar()).drive;
  EXPECT_EQ(skid.kind, Kind::kSkidSteer);
  EXPECT_EQ(skid.base_frame, "chassis");
  EXPECT_EQ(skid.odometry_rate_hz, 100.0);
  EXPECT_TRUE(skid.publishes_odometry);
  EXPECT_FALSE(skid.publishes_transform);

  const CarDescription diff = load(
    withPlugin("libgazebo_ros_diff_drive.so", "<odometryFrame>robot1/odom</odometryFrame><updateRate>30</updateRate>"));
  EXPECT_EQ(diff.drive->kind, Kind::kDifferential);
  EXPECT_EQ(diff.drive->command_topic, "cmd_vel");
  EXPECT_EQ(diff.drive->odometry_frame, "robot1/odom");
  EXPECT_EQ(diff.drive->base_frame, "base_footprint");
  EXPECT_EQ(diff.drive->odometry_rate_hz, 30.0);
  EXPECT_EQ(
    diff.warnings.at(1),
    "racecar.urdf:190: robot[racecar]/gazebo[5]/plugin[drive]: is a second plugin that drives the car and left out");

  const DriveDescription planar = *load(withPlugin("libgazebo_ros_planar_move.so", "")).drive;
  EXPECT_EQ(planar.kind, Kind::kPlanarMove);
  EXPECT_EQ(planar.odometry_rate_hz, 20.0);

  const DriveDescription ackermann = *load(withPlugin(
                                             "libgazebo_ros_ackermann_drive.so",
                                             "<ros><remapping>cmd_vel:=motor</remapping></ros><update_rate>40"
                                             "</update_rate><publish_odom>false</publish_odom>"))
                                        .drive;
  EXPECT_EQ(ackermann.kind, Kind::kAckermann);
  EXPECT_EQ(ackermann.command_topic, "motor");
  EXPECT_EQ(ackermann.odometry_rate_hz, 40.0);
  EXPECT_FALSE(ackermann.publishes_odometry);
  EXPECT_EQ(ackermann.steering_max, 0.6);
  EXPECT_EQ(ackermann.speed_max, 20.0);
}

TEST_F(CarOfOthers, HasTheLimitsAndTheNamespaceOfAnAckermannDrive)
{
  const DriveDescription drive = *load(withPlugin(
                                         "libgazebo_ros_ackermann_drive.so",
                                         "<ros><namespace>demo</namespace><remapping>odom:=/odometry</remapping></ros>"
                                         "<max_steer>0.3</max_steer><max_speed>4</max_speed>"))
                                    .drive;
  EXPECT_EQ(drive.command_topic, "/demo/cmd_vel");
  EXPECT_EQ(drive.odometry_topic, "/odometry");
  EXPECT_EQ(drive.steering_max, 0.3);
  EXPECT_EQ(drive.speed_max, 4.0);
}

TEST_F(CarOfOthers, TakesTheTagsOfRos1OfAnAckermannDrive)
{
  const DriveDescription drive =
    *load(withPlugin(
            "libgazebo_ros_ackermann_drive.so",
            "<odometryFrame>robot1/odom</odometryFrame><robotBaseFrame>chassis</robotBaseFrame>"
            "<updateRate>50</updateRate><publishTf>false</publishTf>"))
       .drive;
  EXPECT_EQ(drive.kind, DriveDescription::Kind::kAckermann);
  EXPECT_EQ(drive.odometry_frame, "robot1/odom");
  EXPECT_EQ(drive.base_frame, "chassis");
  EXPECT_EQ(drive.odometry_rate_hz, 50.0);
  EXPECT_FALSE(drive.publishes_transform);
}

TEST_F(CarOfOthers, WithoutWheelsKeepsItsOwnFrameAndTheDynamicsOfTheF1TenthCar)
{
  const CarDescription car = load(
    "<robot name='r'><link name='body'><inertial><mass value='2'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' "
    "izz='1'/></inertial><collision><geometry><box size='1 1 1'/></geometry></collision></link></robot>");
  EXPECT_EQ(car.base_frame, "body");
  EXPECT_EQ(car.base_frame_pose, Pose3());
  EXPECT_TRUE(car.mechanism.empty());
  EXPECT_EQ(car.parameters.m, 2.0);
  EXPECT_EQ(car.parameters.l_f, VehicleParameters().l_f);
  EXPECT_EQ(car.parameters.v_max, VehicleParameters().v_max);
}
}  // namespace
}  // namespace f1tenth_sim2d
