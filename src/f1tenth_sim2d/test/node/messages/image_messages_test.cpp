#include "node/messages/image_messages.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

namespace f1tenth_sim2d
{
namespace
{
constexpr float kNothing = std::numeric_limits<float>::infinity();

/// Two by two pixels, each of one colour: red, green; blue, white.
Picture picture()
{
  return {2, 2, {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255}, {1.0F, 2.5F, 70.0F, kNothing}};
}

Camera::Eye eyeOf(const std::string & format)
{
  Camera::Eye eye;
  eye.format = format;
  eye.pinhole = eye.calibration = {2, 2, 4.0, 4.0, 0.5, 0.5, 0.1, 100.0};
  eye.points_farthest = 5.0;
  return eye;
}

std::vector<std::uint8_t> imageIn(const std::string & format)
{
  sensor_msgs::Image image;
  fillImage(picture(), eyeOf(format), image);
  EXPECT_EQ(image.encoding, format);
  return image.data;
}
}  // namespace

TEST(ImageMessages, HaveTheFormatOfTheEye)
{
  EXPECT_EQ(imageIn("rgb8"), picture().colours);
  EXPECT_EQ(imageIn("bgr8"), (std::vector<std::uint8_t>{0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255}));
  EXPECT_EQ(imageIn("mono8"), (std::vector<std::uint8_t>{76, 149, 28, 255}));
  EXPECT_EQ(imageIn("bayer_rggb8"), (std::vector<std::uint8_t>{255, 255, 0, 255}));
  EXPECT_EQ(imageIn("bayer_bggr8"), (std::vector<std::uint8_t>{0, 255, 0, 255}));
}

TEST(ImageMessages, GiveDepthInMetresOrMillimetres)
{
  Camera::Eye eye = eyeOf("rgb8");
  sensor_msgs::Image image;
  fillDepth(picture(), eye, image);
  EXPECT_EQ(image.encoding, "32FC1");
  EXPECT_EQ(std::memcmp(image.data.data(), picture().depths.data(), 4 * sizeof(float)), 0);
  eye.depth_in_millimetres = true;
  fillDepth(picture(), eye, image);
  EXPECT_EQ(image.encoding, "16UC1");
  std::array<std::uint16_t, 4> depths{};
  ASSERT_EQ(image.data.size(), sizeof(depths));
  std::memcpy(depths.data(), image.data.data(), sizeof(depths));
  EXPECT_EQ(depths, (std::array<std::uint16_t, 4>{1000, 2500, 0, 0}));
}

TEST(ImageMessages, PutPointsIntoTheOpticalFrame)
{
  sensor_msgs::PointCloud2 points;
  fillPoints(picture(), eyeOf("rgb8"), points);
  ASSERT_EQ(points.data.size(), 4 * points.point_step);
  std::array<float, 3> second{};
  std::memcpy(second.data(), &points.data[points.point_step], sizeof(second));
  EXPECT_EQ(second, (std::array<float, 3>{2.5F * 0.5F / 4.0F, -2.5F * 0.5F / 4.0F, 2.5F}));
  float third = 0.0F;
  std::memcpy(&third, &points.data[2 * points.point_step], sizeof(third));
  EXPECT_TRUE(std::isnan(third)) << "beyond the cutoff";
}

TEST(ImageMessages, TellTheBaselineOfAPair)
{
  Camera::Eye eye = eyeOf("rgb8");
  eye.baseline = 0.12;
  EXPECT_DOUBLE_EQ(toCameraInfo(eye).P[3], -0.48);
}
}  // namespace f1tenth_sim2d
