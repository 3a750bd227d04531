#include "loaders/frames/read_pose.h"

#include <algorithm>
#include <cmath>

#include "loaders/xml/xml_text.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr int kOldest = 103;
constexpr int kOfUrdf = 107;
/// From this version on a frame is named by `relative_to`, before it by `frame`.
constexpr int kWithRelativeTo = 107;

bool isQuaternion(const Element & element)
{
  const std::string format = element.attribute("rotation_format");
  if (!format.empty() && format != "euler_rpy" && format != "quat_xyzw") {
    element.fail("attribute 'rotation_format' is '" + format + "', allowed are euler_rpy and quat_xyzw");
  }
  return format == "quat_xyzw";
}

Pose3 poseOf(const Element & element, const std::vector<double> & n)
{
  const bool is_quaternion = isQuaternion(element);
  if (n.size() != (is_quaternion ? 7 : 6)) {
    element.fail(
      "is '" + element.text() + "', allowed are " +
      (is_quaternion ? "seven numbers: x y z and a quaternion x y z w" : "six numbers: x y z roll pitch yaw"));
  }
  if (!std::all_of(n.begin(), n.end(), [](double number) { return std::isfinite(number); })) {
    element.fail("is '" + element.text() + "', allowed are finite numbers");
  }
  if (is_quaternion) {
    const Pose3::Rotation given(n[6], n[3], n[4], n[5]);
    return {{n[0], n[1], n[2]}, given.norm() > 0.0 ? given.normalized() : Pose3::Rotation::Identity()};
  }
  const double unit = element.flagAttribute("degrees", false) ? M_PI / 180.0 : 1.0;
  return {n[0], n[1], n[2], n[3] * unit, n[4] * unit, n[5] * unit};
}
}  // namespace

int versionIn(const std::string & text)
{
  const std::size_t point = text.find('.');
  const auto major = numberIn(text.substr(0, point));
  const auto minor = point == std::string::npos ? std::nullopt : numberIn(text.substr(point + 1));
  const bool is_version = major && minor && *major >= 0.0 && *major < 100.0 && *minor >= 0.0 && *minor < 100.0;
  return is_version ? static_cast<int>(*major) * 100 + static_cast<int>(*minor) : 0;
}

int sdfVersion(const Element & element)
{
  const Element root = element.root();
  return root.is("sdf") && root.has("version") ? versionIn(root.attribute("version")) : kOfUrdf;
}

void requireSdfVersion(const Element & root, WarningCollector & warnings)
{
  if (!root.has("version")) {
    warnings.add("has no attribute 'version': read as 1.7", root.fileLine());
    return;
  }
  const int version = sdfVersion(root);
  if (version < kOldest || version > kNewestSdfVersion) {
    root.fail("version is '" + root.attribute("version") + "', allowed are 1.3 to 1.9");
  }
}

GivenPose readPose(const Element & owner, const std::string & frame)
{
  const Element element = owner.child("pose");
  if (!element) {
    return {{}, frame, owner};
  }
  const std::string named = element.attribute(sdfVersion(element) >= kWithRelativeTo ? "relative_to" : "frame");
  const std::string & relative_to = named.empty() ? frame : named;
  if (element.text().empty()) {
    return {{}, relative_to, element};
  }
  const auto numbers = numbersIn(element.text());
  if (!numbers) {
    element.fail("is '" + element.text() + "', which is not all numbers");
  }
  return {poseOf(element, *numbers), relative_to, element};
}

Pose3 readOrigin(const Element & owner)
{
  const Element origin = owner.child("origin");
  Eigen::Vector3d xyz = Eigen::Vector3d::Zero();
  Eigen::Vector3d rpy = Eigen::Vector3d::Zero();
  if (origin.has("xyz")) {
    xyz = origin.toVector("attribute 'xyz'", origin.attribute("xyz"));
  }
  if (origin.has("rpy")) {
    rpy = origin.toVector("attribute 'rpy'", origin.attribute("rpy"));
  }
  if (!xyz.allFinite() || !rpy.allFinite()) {
    origin.fail("is not finite");
  }
  return {xyz.x(), xyz.y(), xyz.z(), rpy.x(), rpy.y(), rpy.z()};
}
}  // namespace f1tenth_sim2d
