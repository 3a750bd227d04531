#include "core/components/camera/camera.h"

#include <workspace_support/maths/trigonometry.h>

#include <array>
#include <cmath>
#include <map>

#include "f1tenth_sim2d/errors.h"
#include "loaders/frames/read_pose.h"
#include "loaders/sensors/sensor_readers.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kFovLeast = 0.01;  // rad
constexpr double kFovMost = 3.1;    // rad, of a pinhole camera
constexpr double kSideMax = 8192;   // pixels

/// How sensor_msgs/Image calls the formats of SDF.
const std::map<std::string, std::string> kFormats{
  {"R8G8B8", "rgb8"},
  {"RGB_INT8", "rgb8"},
  {"B8G8R8", "bgr8"},
  {"BGR_INT8", "bgr8"},
  {"L8", "mono8"},
  {"L_INT8", "mono8"},
  {"BAYER_RGGB8", "bayer_rggb8"},
  {"BAYER_BGGR8", "bayer_bggr8"},
  {"BAYER_GBRG8", "bayer_gbrg8"},
  {"BAYER_GRBG8", "bayer_grbg8"}};

double within(const Element & camera, const char * tag, double fallback, double least, double most)
{
  const double value = camera.number(tag, fallback);
  if (!(value >= least && value <= most)) {
    camera.fail(
      "<" + std::string(tag) + "> is " + toText(value) + ", allowed are " + toText(least) + " to " + toText(most));
  }
  return value;
}

Pinhole readPinhole(const Element & camera)
{
  Pinhole pinhole;
  pinhole.width = static_cast<int>(within(camera, "image/width", 320.0, 1.0, kSideMax));
  pinhole.height = static_cast<int>(within(camera, "image/height", 240.0, 1.0, kSideMax));
  const double half = 0.5 * within(camera, "horizontal_fov", 1.047, kFovLeast, kFovMost);
  const maths::SineCosine at = maths::sineCosine(half);
  pinhole.focal_x = pinhole.focal_y = 0.5 * pinhole.width * at.cosine / at.sine;
  pinhole.middle_x = 0.5 * (pinhole.width - 1);
  pinhole.middle_y = 0.5 * (pinhole.height - 1);
  pinhole.near = within(camera, "clip/near", 0.1, 1e-3, 1e6);
  pinhole.far = within(camera, "clip/far", 100.0, pinhole.near, 1e6);
  return pinhole;
}

std::string formatOf(const Element & camera, CarContext & context)
{
  const std::string given = camera.child("image").textOf("format", "R8G8B8");
  const auto found = kFormats.find(given);
  if (found == kFormats.end()) {
    context.warnings.add("<format> " + given + " is not known: R8G8B8 is used", camera.fileLine());
  }
  return found == kFormats.end() ? "rgb8" : found->second;
}

Camera::Eye readEye(const Element & camera, const SensorElement & element, CarContext & context)
{
  Camera::Eye eye;
  eye.name = camera.name();
  eye.pose = element.pose * readPose(camera, "").pose;
  eye.pinhole = readPinhole(camera);
  eye.noise_stddev = stddevOf(camera.child("noise"));
  eye.format = formatOf(camera, context);
  if (const Element distortion = camera.child("distortion")) {
    context.warnings.add("<distortion> is left out: cameras are pinholes", distortion.fileLine());
  }
  return eye;
}

/// What the eyes of a multicamera are called in topics; as in gazebo_ros, "left" and "right" if their names say so.
std::string partOf(const std::string & eye)
{
  for (const char * const side : {"left", "right"}) {
    if (eye.find(side) != std::string::npos) {
      return side;
    }
  }
  return eye;
}

/// What the plug-in says of the lens, which Gazebo does not draw either.
void readCalibration(const Element & plugin, Camera::Eye & eye, WarningCollector & warnings)
{
  eye.calibration = eye.pinhole;
  Pinhole & told = eye.calibration;
  // 0 means: as it is drawn.
  const auto unlessZero = [&](const char * tag, double fallback) {
    const double value = plugin.number(tag, 0.0);
    return value == 0.0 ? fallback : value;
  };
  told.middle_x = unlessZero("Cx", told.middle_x);
  told.middle_y = unlessZero("Cy", told.middle_y);
  told.focal_x = told.focal_y = unlessZero("focalLength", told.focal_x);
  constexpr double kRounding = 1e-3;  // pixels
  if (std::abs(told.focal_x - eye.pinhole.focal_x) > kRounding) {
    warnings.add(
      "<focalLength> is " + toText(told.focal_x) + ", but pictures of this width and <horizontal_fov> have " +
        toText(eye.pinhole.focal_x),
      plugin.fileLine());
  }
  constexpr std::array<const char *, 5> kTags{
    "distortionK1", "distortionK2", "distortionT1", "distortionT2", "distortionK3"};
  for (std::size_t i = 0; i < kTags.size(); ++i) {
    eye.distortion[i] = plugin.number(kTags[i], 0.0);
  }
}

/// @param space  in which the topics are: the name of the camera
void publish(Camera::Eye & eye, const std::string & space, const SensorElement & element, CarContext & context)
{
  const Element & plugin = element.plugin;
  const auto topic = [&](const char * tag, const char * fallback) {
    const std::string name = plugin.textOf(tag, fallback);
    return context.topic(plugin, name.front() == '/' ? name : space + "/" + name);
  };
  const std::string library = libraryName(plugin);
  readCalibration(plugin, eye, context.warnings);
  eye.image_topic = topic("imageTopicName", "image_raw");
  eye.info_topic = topic("cameraInfoTopicName", "camera_info");
  eye.baseline = space.find("left") == std::string::npos ? plugin.number("hackBaseline", 0.0) : 0.0;
  if (library == "libgazebo_ros_depth_camera.so" || library == "libgazebo_ros_openni_kinect.so") {
    eye.depth_topic = topic("depthImageTopicName", "depth/image_raw");
    eye.depth_info_topic = topic("depthImageCameraInfoTopicName", "depth/camera_info");
    eye.points_topic = topic("pointCloudTopicName", "points");
    eye.points_nearest = plugin.notNegative("pointCloudCutoff", 0.4);
    eye.points_farthest = plugin.notNegative("pointCloudCutoffMax", 5.0);
    eye.depth_in_millimetres = plugin.flag("useDepth16UC1Format", false);
  }
}

/// Gazebo publishes nothing of a camera without plugin; it can be looked through all the same.
Mount mountOf(const SensorElement & element, CarContext & context)
{
  Mount mount;
  mount.name = element.sensor.name();
  mount.pose = element.pose;
  mount.rate_hz = publishingRate(element);
  mount.frame = element.plugin ? frameOf(element.plugin, context) : element.link;
  return mount;
}

void addCamera(const SensorElement & element, CarContext & context)
{
  const std::vector<Element> cameras = element.sensor.children("camera");
  if (cameras.empty()) {
    element.sensor.fail("has no <camera>");
  }
  std::vector<Camera::Eye> eyes;
  const std::string space = element.plugin.textOf("cameraName", element.sensor.name());
  for (const Element & camera : cameras) {
    Camera::Eye & eye = eyes.emplace_back(readEye(camera, element, context));
    if (element.plugin) {
      publish(eye, cameras.size() > 1 ? space + "/" + partOf(eye.name) : space, element, context);
    }
  }
  context.car.components.push_back(std::make_shared<Camera>(mountOf(element, context), std::move(eyes)));
}
}  // namespace

void readCamera(const SensorElement & element, CarContext & context)
{
  // Cars with it could always be driven: it is left out instead of refusing them.
  try {
    addCamera(element, context);
  } catch (const LoadError & error) {
    context.warnings.add(std::string("a camera is left out: ") + error.what(), element.sensor.fileLine());
  }
}
}  // namespace f1tenth_sim2d
