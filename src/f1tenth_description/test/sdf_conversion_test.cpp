#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <sdf/sdf.hh>
#include <string>

namespace
{
/// The car after the conversion from URDF to SDF that Gazebo and the simulator do.
class SdfConversion : public testing::Test
{
protected:
  void SetUp() override
  {
    const sdf::Errors errors = root_.Load(ROBOT_DESCRIPTION_FILE);
    for (const sdf::Error & error : errors) {
      ADD_FAILURE() << error.Message();
    }
    ASSERT_NE(root_.Model(), nullptr);
    const sdf::Model & car = *root_.Model();
    for (std::uint64_t i = 0; i < car.LinkCount(); ++i) {
      const sdf::Link & link = *car.LinkByIndex(i);
      for (std::uint64_t j = 0; j < link.SensorCount(); ++j) {
        sensors_[link.SensorByIndex(j)->Name()] = {&link, link.SensorByIndex(j)};
      }
    }
  }

  struct PlacedSensor
  {
    const sdf::Link * link;
    const sdf::Sensor * sensor;
  };

  /// Pose of a link of the car in base_footprint.
  ignition::math::Pose3d poseOf(const std::string & link) const
  {
    ignition::math::Pose3d pose;
    EXPECT_TRUE(root_.Model()->LinkByName(link)->SemanticPose().Resolve(pose, "base_footprint").empty());
    return pose;
  }

  sdf::Root root_;
  std::map<std::string, PlacedSensor> sensors_;
};

TEST_F(SdfConversion, KeepsBaseFootprintAsRootLink)
{
  EXPECT_EQ(root_.Model()->Name(), "f1tenth");
  EXPECT_EQ(root_.Model()->LinkByIndex(0)->Name(), "base_footprint");
}

TEST_F(SdfConversion, KeepsOneLidarWithItsBeams)
{
  const sdf::Sensor & sensor = *sensors_.at("lidar").sensor;
  ASSERT_EQ(sensor.Type(), sdf::SensorType::LIDAR);
  EXPECT_DOUBLE_EQ(sensor.UpdateRate(), 40.0);
  const sdf::Lidar & lidar = *sensor.LidarSensor();
  EXPECT_EQ(lidar.HorizontalScanSamples(), 1081u);
  EXPECT_NEAR(lidar.HorizontalScanMinAngle().Radian(), -135.0 / 180.0 * M_PI, 1e-6);
  EXPECT_NEAR(lidar.HorizontalScanMaxAngle().Radian(), 135.0 / 180.0 * M_PI, 1e-6);
  EXPECT_DOUBLE_EQ(lidar.RangeMin(), 0.06);
  EXPECT_DOUBLE_EQ(lidar.RangeMax(), 10.0);
  EXPECT_EQ(lidar.LidarNoise().Type(), sdf::NoiseType::GAUSSIAN);
  EXPECT_DOUBLE_EQ(lidar.LidarNoise().StdDev(), 0.01);
}

TEST_F(SdfConversion, KeepsTheLidarLevelAndAboveTheCar)
{
  ignition::math::Pose3d pose;
  ASSERT_TRUE(sensors_.at("lidar").sensor->SemanticPose().Resolve(pose, "base_footprint").empty());
  EXPECT_NEAR(pose.X(), 0.275, 1e-9);
  EXPECT_NEAR(pose.Y(), 0.0, 1e-9);
  EXPECT_NEAR(pose.Z(), 0.16, 1e-9);
  EXPECT_NEAR(pose.Rot().Roll(), 0.0, 1e-9);
  EXPECT_NEAR(pose.Rot().Pitch(), 0.0, 1e-9);
}

TEST_F(SdfConversion, KeepsFourContactSensorsWithExistingCollisions)
{
  for (const std::string name : {"bumper_front", "bumper_rear", "bumper_left", "bumper_right"}) {
    SCOPED_TRACE(name);
    const PlacedSensor & placed = sensors_.at(name);
    EXPECT_EQ(placed.sensor->Type(), sdf::SensorType::CONTACT);
    EXPECT_DOUBLE_EQ(placed.sensor->UpdateRate(), 50.0);
    EXPECT_EQ(placed.link->Name(), name);
    const auto collision = placed.sensor->Element()->GetElement("contact")->Get<std::string>("collision");
    EXPECT_NE(placed.link->CollisionByName(collision), nullptr) << collision;
    const auto plugin = placed.sensor->Element()->GetElement("plugin");
    EXPECT_EQ(plugin->Get<std::string>("filename"), "libgazebo_ros_bumper.so");
    EXPECT_EQ(plugin->Get<std::string>("bumperTopicName"), name);
  }
}

TEST_F(SdfConversion, PutsEachBumperOnItsSide)
{
  EXPECT_GT(poseOf("bumper_front").X(), poseOf("front_left_wheel").X());
  EXPECT_LT(poseOf("bumper_rear").X(), poseOf("rear_left_wheel").X());
  EXPECT_GT(poseOf("bumper_left").Y(), poseOf("front_left_wheel").Y());
  EXPECT_LT(poseOf("bumper_right").Y(), poseOf("front_right_wheel").Y());
}

TEST_F(SdfConversion, KeepsStereoCameraAndImu)
{
  const sdf::Sensor & camera = *sensors_.at("stereo_camera").sensor;
  EXPECT_EQ(camera.Type(), sdf::SensorType::MULTICAMERA);
  EXPECT_EQ(sensors_.at("imu").sensor->Type(), sdf::SensorType::IMU);
  EXPECT_DOUBLE_EQ(sensors_.at("imu").sensor->UpdateRate(), 100.0);
  EXPECT_EQ(sensors_.size(), 7u);
}

TEST_F(SdfConversion, KeepsWheelsAndSteeringAsJoints)
{
  const sdf::Model & car = *root_.Model();
  for (const std::string side : {"left", "right"}) {
    const sdf::JointAxis & steering = *car.JointByName("front_" + side + "_steering_joint")->Axis();
    EXPECT_NEAR(steering.Lower(), -0.4189, 1e-9);
    EXPECT_NEAR(steering.Upper(), 0.4189, 1e-9);
    for (const std::string end : {"front_", "rear_"}) {
      const sdf::Joint & wheel = *car.JointByName(end + side + "_wheel_joint");
      EXPECT_EQ(wheel.Axis()->Xyz(), ignition::math::Vector3d::UnitY);
    }
  }
  EXPECT_NEAR(poseOf("front_left_wheel").X() - poseOf("rear_left_wheel").X(), 0.3302, 1e-9);
}

TEST_F(SdfConversion, KeepsThePluginsOfTheCar)
{
  std::map<std::string, sdf::ElementPtr> plugins;
  for (auto plugin = root_.Model()->Element()->GetElement("plugin"); plugin;
       plugin = plugin->GetNextElement("plugin")) {
    plugins[plugin->Get<std::string>("filename")] = plugin;
  }
  EXPECT_EQ(plugins.count("libgazebo_ros_joint_state_publisher.so"), 1u);
  const auto odometry = plugins.at("libf1tenth_perfect_odometry.so");
  EXPECT_TRUE(odometry->Get<bool>("alwaysOn"));
  EXPECT_DOUBLE_EQ(odometry->Get<double>("updateRate"), 200.0);
  EXPECT_EQ(odometry->Get<std::string>("odometryTopic"), "perfect_odom");
  EXPECT_EQ(odometry->Get<std::string>("odometryFrame"), "odom");
  EXPECT_EQ(odometry->Get<std::string>("robotBaseFrame"), "base_footprint");
  EXPECT_EQ(odometry->Get<std::string>("rosDebugLevel"), "na");
}

TEST_F(SdfConversion, WeighsAsTheCarThatTheSimulatorDrives)
{
  const sdf::Model & car = *root_.Model();
  ignition::math::Inertiald total;
  for (std::uint64_t i = 0; i < car.LinkCount(); ++i) {
    const sdf::Link & link = *car.LinkByIndex(i);
    ignition::math::Inertiald inertial = link.Inertial();
    inertial.SetPose(poseOf(link.Name()) * inertial.Pose());
    total = i == 0 ? inertial : total + inertial;
  }
  EXPECT_NEAR(total.MassMatrix().Mass(), 3.74, 1e-6);
  EXPECT_NEAR(total.Pose().Pos().X(), 0.17145, 1e-4);
  EXPECT_NEAR(total.Pose().Pos().Y(), 0.0, 1e-6);
  EXPECT_NEAR(total.Pose().Pos().Z(), 0.074, 1e-4);
  EXPECT_NEAR(total.Moi()(2, 2), 0.04712, 0.0001);
}
}  // namespace

int main(int argc, char ** argv)
{
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
