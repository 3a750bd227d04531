#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "f1tenth_sim2d/loaders.h"
#include "small_car.h"

// Warnings of cameras: nothing of them refuses a car.
namespace f1tenth_sim2d
{
namespace
{
CarDescription loadCarWithCamera(const std::string & xml)
{
  return loadCar(xml, "robot1", "test.urdf", {});
}

TEST(LoadCamera, SaysWhichFrameItTakes)
{
  const std::vector<std::string> expected{
    "test.urdf:234: robot[small_car]/gazebo[base_link]/sensor[camera]/plugin[camera_plugin]: has no <frameName>: taken "
    "as 'world', as in gazebo_ros"};
  EXPECT_EQ(loadCarWithCamera(smallCar()).warnings, expected);
}

TEST(LoadCamera, NamesTagsThatSayAnotherLens)
{
  const std::string lens = "<camera><distortion><k1>-0.1</k1><center>0.4 0.5</center></distortion>";
  const CarDescription car = loadCarWithCamera(smallCarWith("<camera>", lens));
  ASSERT_EQ(car.warnings.size(), 3u);
  EXPECT_NE(car.warnings[0].find("<center> 0.4 0.5 of the lens is left out"), std::string::npos);
  EXPECT_NE(car.warnings[1].find("camera_info tells another lens"), std::string::npos);
  EXPECT_EQ(loadCarWithCamera(smallCarWith("<camera>", "<camera><distortion/>")).warnings.size(), 1u);
}

TEST(LoadCamera, NamesAnAbsurdLens)
{
  const CarDescription car =
    loadCarWithCamera(smallCarWith("<camera>", "<camera><distortion><k1>1e9</k1></distortion>"));
  ASSERT_EQ(car.warnings.size(), 1u);
  EXPECT_NE(car.warnings[0].find("<k1> is 1e+09, allowed are -10000 to 10000"), std::string::npos);
}

TEST(LoadCamera, NamesWhatIsLeftOut)
{
  const CarDescription car = loadCarWithCamera(smallCarWith("<horizontal_fov>1.5", "<horizontal_fov>7"));
  ASSERT_EQ(car.warnings.size(), 1u);
  EXPECT_NE(car.warnings[0].find("a camera is left out"), std::string::npos);
  EXPECT_NE(car.warnings[0].find("<horizontal_fov> is 7, allowed are 0.01 to 3.1"), std::string::npos);
}

TEST(LoadCamera, NamesNoiseThatHidesEverything)
{
  const auto warningsOf = [](const std::string & stddev) {
    return loadCarWithCamera(smallCarWith("<camera>", "<camera><noise><stddev>" + stddev + "</stddev></noise>"))
      .warnings;
  };
  EXPECT_EQ(warningsOf("1").size(), 1U);
  ASSERT_EQ(warningsOf("1e9").size(), 2U);
  EXPECT_NE(warningsOf("1e9")[0].find("/camera/noise: <stddev> is 1e+09 times the brightest light"), std::string::npos)
    << warningsOf("1e9")[0];
}
}  // namespace
}  // namespace f1tenth_sim2d
