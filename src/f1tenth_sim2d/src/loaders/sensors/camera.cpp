#include "core/components/camera/camera.h"

#include <workspace_support/maths/trigonometry.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>

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
constexpr double kSameLens = 1e-6;  // many cars of others tell 1e-8 where they mean nothing

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

const std::set<std::string> kTriggered{"libgazebo_ros_triggered_camera.so", "libgazebo_ros_triggered_multicamera.so"};
const std::set<std::string> kWithDepth{"libgazebo_ros_depth_camera.so", "libgazebo_ros_openni_kinect.so"};

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

/// Null where it would change nothing.
std::shared_ptr<const Lens> readLens(
  const Element & camera, const Element & plugin, const Pinhole & pinhole, WarningCollector & warnings)
{
  const Element element = camera.child("distortion");
  constexpr double kMost = 1e4;
  const auto of = [&](const char * tag) { return within(element, tag, 0.0, -kMost, kMost); };
  const Distortion distortion = element ? Distortion{of("k1"), of("k2"), of("p1"), of("p2"), of("k3")} : Distortion{};
  if (distortion == Distortion{}) {
    return nullptr;
  }
  const std::string centre = element.textOf("center", "0.5 0.5");
  if (centre != "0.5 0.5") {
    warnings.add("<center> " + centre + " of the lens is left out: it is taken as the middle", element.fileLine());
  }
  return std::make_shared<const Lens>(pinhole, distortion, plugin.flag("borderCrop", true));
}

Camera::Eye readEye(const Element & camera, const SensorElement & element, CarContext & context)
{
  Camera::Eye eye;
  eye.name = camera.name();
  eye.pose = element.pose * readPose(camera, "").pose;
  eye.pinhole = readPinhole(camera);
  eye.noise_stddev = stddevOf(camera.child("noise"));
  if (eye.noise_stddev > 1.0) {
    context.warnings.add(
      "<stddev> is " + toText(eye.noise_stddev) + " times the brightest light: nothing else is seen",
      camera.child("noise").fileLine());
  }
  eye.format = formatOf(camera, context);
  eye.lens = readLens(camera, element.plugin, eye.pinhole, context.warnings);
  if (eye.lens) {
    eye.pinhole = eye.lens->bent();
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

/// What the plug-in says of the lens, which is drawn as the sensor says.
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
  if (plugin.number("CxPrime", 0.0) != 0.0) {
    warnings.add("<CxPrime> changes nothing, as in gazebo_ros", plugin.fileLine());
  }
  const Distortion drawn = eye.lens ? eye.lens->distortion() : Distortion{};
  if (plugin.flag("autoDistortion", false)) {
    eye.distortion = drawn;
    return;
  }
  const auto of = [&](const char * tag) { return plugin.number(tag, 0.0); };
  eye.distortion = {of("distortionK1"), of("distortionK2"), of("distortionT1"), of("distortionT2"), of("distortionK3")};
  const auto differs = [](double one, double other) { return std::abs(one - other) > kSameLens; };
  if (std::mismatch(drawn.begin(), drawn.end(), eye.distortion.begin(), std::not_fn(differs)).first != drawn.end()) {
    warnings.add(
      "camera_info tells another lens (<distortionK1> and the like) than is drawn (<distortion>);"
      " <autoDistortion>true</autoDistortion> tells that which is drawn",
      plugin.fileLine());
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
  if (kTriggered.count(library) > 0) {
    eye.trigger_topic = topic("triggerTopicName", "image_trigger");
  }
  if (kWithDepth.count(library) > 0) {
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
