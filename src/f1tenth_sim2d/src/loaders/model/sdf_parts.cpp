#include "loaders/model/sdf_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <set>
#include <string>

#include "loaders/frames/read_pose.h"
#include "loaders/model/known_tags.h"
#include "loaders/shapes/read_shape.h"
#include "loaders/visuals/read_visual.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kEndlessFriction = 1e6;
constexpr double kUnlimited = 1e15;    // SDF's own default limits are 1e16
constexpr int kWithAxesInModel = 104;  // up to this version the axis of a joint is given in the frame of the model

/// Without <inertial> a link of SDF weighs 1 kg.
Inertia readInertia(const Element & link, WarningCollector & warnings)
{
  const Element inertial = link.child("inertial");
  const Element m = inertial.child("inertia");
  const auto moment = [&m](const char * tag, double fallback) { return m ? m.number(tag, fallback) : fallback; };
  const Inertia about_itself{
    inertial ? inertial.number("mass", 1.0) : 1.0, Eigen::Vector3d::Zero(),
    symmetric(
      moment("ixx", 1.0), moment("iyy", 1.0), moment("izz", 1.0), moment("ixy", 0.0), moment("ixz", 0.0),
      moment("iyz", 0.0))};
  if (!inertial) {
    return about_itself;
  }
  warnOfChildren(inertial, warnings);
  warnOfInertia(inertial, about_itself, warnings);
  return placed(about_itself, readPose(inertial, "").pose);
}

std::optional<Solid> readCollision(
  const Element & collision, const LinkPart & link, const FrameScope & frames, MeshLibrary & meshes,
  WarningCollector & warnings)
{
  warnOfChildren(collision, warnings);
  Solid solid;
  solid.name = collision.requiredAttribute("name");
  const Element geometry = collision.child("geometry");
  if (!geometry) {
    collision.fail("has no <geometry>");
  }
  std::optional<Shape> shape = readShape(geometry, meshes, solid.pose);
  warnOfChildren(geometry.children().front(), warnings);
  if (!shape) {
    return std::nullopt;
  }
  solid.shape = *std::move(shape);
  solid.pose = frames.resolved(readPose(collision, link.name)) * solid.pose;
  collision.requireNear(solid.pose.position);
  readSurface(collision.child("surface"), solid, warnings);
  return solid;
}

double restitutionOf(const Element & bounce, double fallback, WarningCollector & warnings)
{
  const double share = bounce.notNegative("restitution_coefficient", fallback);
  if (share > 1.0) {
    warnings.add(
      "restitution_coefficient beyond 1 is taken as 1: no bounce gives more than it takes", bounce.fileLine());
  }
  return std::min(share, 1.0);
}

double limitOf(double value)
{
  return std::abs(value) < kUnlimited ? value : std::copysign(std::numeric_limits<double>::infinity(), value);
}

/// Limits of effort and velocity; what is not positive means that there is none.
double positiveLimitOf(double value)
{
  return value > 0.0 ? limitOf(value) : std::numeric_limits<double>::infinity();
}

/// In which frame the axis of a joint is given.
std::string axisFrame(const Element & axis, const JointPart & joint)
{
  const std::string expressed_in = axis.child("xyz").attribute("expressed_in");
  if (!expressed_in.empty()) {
    return expressed_in;
  }
  const bool in_model = sdfVersion(axis) <= kWithAxesInModel || axis.flag("use_parent_model_frame", false);
  return in_model ? "" : joint.name;
}

void readAxis(const Element & axis, const FrameScope & frames, JointPart & joint)
{
  const Eigen::Vector3d xyz = axis.vector("xyz", Eigen::Vector3d::UnitZ());
  joint.axis = frames.poseOf(axisFrame(axis, joint), axis).rotation * xyz;
  joint.lower = limitOf(axis.number("limit/lower", joint.lower));
  joint.upper = limitOf(axis.number("limit/upper", joint.upper));
  joint.effort = positiveLimitOf(axis.number("limit/effort", -1.0));
  joint.velocity = positiveLimitOf(axis.number("limit/velocity", -1.0));
}

/// Warns of something that Gazebo lets everything pass through.
void warnOfGhost(const Element & contact, WarningCollector & warnings)
{
  if (contact.flag("collide_without_contact", false)) {
    warnings.add("<collide_without_contact> is left out: what a lidar sees is solid", contact.fileLine());
  }
  if (std::strtoul(contact.textOf("collide_bitmask", "1").c_str(), nullptr, 0) == 0) {
    warnings.add("<collide_bitmask> of 0 is left out: what a lidar sees is solid", contact.fileLine());
  }
}

// Gazebo accepts them.
void warnOfTakenName(const Element & collision, std::set<std::string> & names, WarningCollector & warnings)
{
  if (!names.insert(collision.requiredAttribute("name")).second) {
    warnings.add("this name is taken by another collision of the link: contacts of both have it", collision.fileLine());
  }
}
}  // namespace

void readLink(LinkPart & link, const FrameScope & frames, MeshLibrary & meshes, WarningCollector & warnings)
{
  warnOfChildren(link.element, warnings);
  link.pose = frames.poseOf(link.name, link.element);
  link.inertia = placed(readInertia(link.element, warnings), link.pose);
  std::set<std::string> names;
  for (const Element & collision : link.element.children("collision")) {
    warnOfTakenName(collision, names, warnings);
    if (std::optional<Solid> solid = readCollision(collision, link, frames, meshes, warnings)) {
      link.solids.push_back(*std::move(solid));
    }
  }
  for (const Element & visual : link.element.children("visual")) {
    const auto pose = [&] { return frames.resolved(readPose(visual, link.name)); };
    link.visuals.push_back(readVisual(visual, pose, meshes));
  }
  for (const Element & sensor : link.element.children("sensor")) {
    link.sensors.push_back({sensor, frames.resolved(readPose(sensor, link.name))});
  }
}

void readJoint(JointPart & joint, const FrameScope & frames)
{
  joint.type = joint.element.requiredAttribute("type");
  joint.parent = joint.element.child("parent").text();
  joint.child = joint.element.child("child").text();
  joint.pose = frames.poseOf(joint.name, joint.element);
  if (const Element axis = joint.element.child("axis")) {
    readAxis(axis, frames, joint);
  }
}

void readSurface(const Element & surface, Solid & solid, WarningCollector & warnings)
{
  warnOfGhost(surface.child("contact"), warnings);
  if (const Element friction = surface.child("friction").child("ode")) {
    solid.mu = frictionOf(friction, friction.number("mu", solid.mu), warnings);
  }
  if (const Element bounce = surface.child("bounce")) {
    solid.restitution = restitutionOf(bounce, solid.restitution, warnings);
  }
}

double frictionOf(const Element & element, double mu, WarningCollector & warnings)
{
  if (!std::isfinite(mu)) {
    element.requireNotNegative("<mu>", mu);
  }
  if (mu < 0.0) {
    warnings.add("friction of less than 0 is taken as endless, as Gazebo does", element.fileLine());
    return kEndlessFriction;
  }
  if (mu > kEndlessFriction) {
    warnings.add("friction beyond 1e6 is taken as 1e6: nothing slips with less, either", element.fileLine());
  }
  return std::min(mu, kEndlessFriction);
}

void warnOfInertia(const Element & place, const Inertia & inertia, WarningCollector & warnings)
{
  if (!inertia.isPossible()) {
    warnings.add(
      "no body has this mass and inertia; only mass and yaw inertia of what moves are used", place.fileLine());
  }
}
}  // namespace f1tenth_sim2d
