#include "node/messages/image_messages.h"

#include <leptonica/allheaders.h>
#include <sensor_msgs/distortion_models.h>
#include <sensor_msgs/image_encodings.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>

namespace f1tenth_sim2d
{
namespace
{
namespace encodings = sensor_msgs::image_encodings;

constexpr l_int32 kJpegQuality = 80;  // as compressed_image_transport

void setSize(const Picture & picture, const std::string & encoding, unsigned bytes, sensor_msgs::Image & image)
{
  image.width = static_cast<std::uint32_t>(picture.width);
  image.height = static_cast<std::uint32_t>(picture.height);
  image.encoding = encoding;
  image.step = image.width * bytes;
  image.data.resize(std::size_t{image.step} * image.height);
}

/// Weights of ITU-R BT.601, in 256ths.
std::uint8_t greyOf(const std::uint8_t * colour)
{
  return static_cast<std::uint8_t>((77 * colour[0] + 150 * colour[1] + 29 * colour[2]) >> 8);
}

/// Which channel each pixel of a square of two by two has: "bayer_rggb8" names them.
void fillBayer(const Picture & picture, const std::string & format, std::uint8_t * data)
{
  const std::string channels = "rgb";
  const std::size_t first = format.find('_') + 1;
  const auto width = static_cast<std::size_t>(picture.width);
  for (std::size_t i = 0; i < picture.depths.size(); ++i) {
    const std::size_t cell = i / width % 2 * 2 + i % width % 2;
    data[i] = picture.colours[3 * i + channels.find(format[first + cell])];
  }
}

struct DestroyPix
{
  void operator()(Pix * pix) const { pixDestroy(&pix); }
};
}  // namespace

sensor_msgs::CameraInfo toCameraInfo(const Camera::Eye & eye)
{
  const Pinhole & pinhole = eye.calibration;
  sensor_msgs::CameraInfo info;
  info.width = static_cast<std::uint32_t>(pinhole.width);
  info.height = static_cast<std::uint32_t>(pinhole.height);
  info.distortion_model = sensor_msgs::distortion_models::PLUMB_BOB;
  info.D.assign(eye.distortion.begin(), eye.distortion.end());
  info.K = {pinhole.focal_x, 0.0, pinhole.middle_x, 0.0, pinhole.focal_y, pinhole.middle_y, 0.0, 0.0, 1.0};
  info.R = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0};
  info.P = {
    pinhole.focal_x,
    0.0,
    pinhole.middle_x,
    -pinhole.focal_x * eye.baseline,
    0.0,
    pinhole.focal_y,
    pinhole.middle_y,
    0.0,
    0.0,
    0.0,
    1.0,
    0.0};
  return info;
}

void fillImage(const Picture & picture, const Camera::Eye & eye, sensor_msgs::Image & image)
{
  const bool has_colours = eye.format == encodings::RGB8 || eye.format == encodings::BGR8;
  setSize(picture, eye.format, has_colours ? 3 : 1, image);
  if (eye.format == encodings::RGB8) {
    image.data = picture.colours;
  } else if (eye.format == encodings::MONO8) {
    for (std::size_t i = 0; i < image.data.size(); ++i) {
      image.data[i] = greyOf(&picture.colours[3 * i]);
    }
  } else if (eye.format == encodings::BGR8) {
    for (std::size_t i = 0; i < image.data.size(); ++i) {
      image.data[i] = picture.colours[i - i % 3 + (2 - i % 3)];
    }
  } else {
    fillBayer(picture, eye.format, image.data.data());
  }
}

void fillDepth(const Picture & picture, const Camera::Eye & eye, sensor_msgs::Image & image)
{
  if (!eye.depth_in_millimetres) {
    setSize(picture, encodings::TYPE_32FC1, sizeof(float), image);
    std::memcpy(image.data.data(), picture.depths.data(), image.data.size());
    return;
  }
  constexpr float kMost = 65535.0F;
  setSize(picture, encodings::TYPE_16UC1, sizeof(std::uint16_t), image);
  for (std::size_t i = 0; i < picture.depths.size(); ++i) {
    const float millimetres = 1000.0F * picture.depths[i] + 0.5F;
    const auto depth = static_cast<std::uint16_t>(millimetres < kMost ? millimetres : 0.0F);
    std::memcpy(&image.data[2 * i], &depth, sizeof(depth));
  }
}

void fillJpeg(const Picture & picture, sensor_msgs::CompressedImage & image)
{
  const std::unique_ptr<Pix, DestroyPix> pix(pixCreate(picture.width, picture.height, 32));
  for (int row = 0; row < picture.height; ++row) {
    l_uint32 * const words = pixGetData(pix.get()) + static_cast<std::ptrdiff_t>(row) * pixGetWpl(pix.get());
    const std::uint8_t * colours =
      &picture.colours[3 * static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.width)];
    for (int column = 0; column < picture.width; ++column, colours += 3) {
      composeRGBPixel(colours[0], colours[1], colours[2], words + column);
    }
  }
  l_uint8 * bytes = nullptr;
  std::size_t size = 0;
  image.format = "rgb8; jpeg compressed bgr8";
  image.data.clear();
  if (pixWriteMemJpeg(&bytes, &size, pix.get(), kJpegQuality, 0) == 0) {
    image.data.assign(bytes, bytes + size);
  }
  lept_free(bytes);
}

void fillPoints(const Picture & picture, const Camera::Eye & eye, sensor_msgs::PointCloud2 & points)
{
  sensor_msgs::PointCloud2Modifier modifier(points);
  if (points.fields.empty()) {
    modifier.setPointCloud2FieldsByString(2, "xyz", "rgb");
  }
  modifier.resize(picture.depths.size());
  points.width = static_cast<std::uint32_t>(picture.width);
  points.height = static_cast<std::uint32_t>(picture.height);
  points.row_step = points.width * points.point_step;
  points.is_dense = false;
  sensor_msgs::PointCloud2Iterator<float> place(points, "x");
  sensor_msgs::PointCloud2Iterator<std::uint8_t> colour(points, "rgb");
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t i = 0; i < picture.depths.size(); ++i, ++place, ++colour) {
    const float depth = picture.depths[i];
    const bool is_there = depth > eye.points_nearest && depth < eye.points_farthest;
    const Vec3 ray = eye.ray(i);
    place[0] = is_there ? static_cast<float>(-depth * ray.y) : kNone;
    place[1] = is_there ? static_cast<float>(-depth * ray.z) : kNone;
    place[2] = is_there ? depth : kNone;
    for (int channel = 0; channel < 3; ++channel) {
      colour[channel] = picture.colours[3 * i + 2 - static_cast<std::size_t>(channel)];  // blue is the lowest byte
    }
  }
}
}  // namespace f1tenth_sim2d
