#include "loaders/model/urdf_model.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "loaders/frames/read_pose.h"
#include "loaders/model/known_urdf.h"
#include "loaders/model/sdf_parts.h"
#include "loaders/model/urdf_extensions.h"
#include "loaders/model/urdf_tree.h"
#include "loaders/shapes/read_shape.h"
#include "loaders/visuals/read_visual.h"

namespace f1tenth_sim2d
{
namespace
{
constexpr double kLeastMass = 1e-6;  // kg; Gazebo treats less as none

/// What <gazebo reference="LINK"> may hold besides sensors; all of it is read elsewhere or changes nothing here.
const std::set<std::string> kOfLinks{
  "canonicalBody",
  "collision",
  "dampingFactor",
  "enable_wind",
  "fdir1",
  "gravity",
  "implicitSpringDamper",
  "kd",
  "kinematic",
  "kp",
  "laserRetro",
  "light",
  "material",
  "maxContacts",
  "maxVel",
  "minDepth",
  "mu1",
  "mu2",
  "pose",
  "selfCollide",
  "self_collide",
  "sensor",
  "static",
  "turnGravityOff",
  "velocity_decay",
  "visual"};

double positiveOrInfinite(double value)
{
  return value > 0.0 ? value : std::numeric_limits<double>::infinity();
}

class UrdfModel
{
public:
  UrdfModel(const Element & robot, MeshLibrary & meshes, WarningCollector & warnings)
  : meshes_(meshes), warnings_(warnings), tree_(robot), extensions_(robot, tree_, warnings)
  {
    warnOfUnknownUrdf(robot, warnings);
    model_.element = robot;
    model_.name = robot.name();
    model_.root_link = tree_.root().name;
    model_.transmissions = robot.children("transmission");
    model_.given_pose = {readOrigin(robot), "", robot};
    for (const auto & [name, link] : tree_.links()) {
      model_.link_poses[name] = link.pose;
      model_.frames->add(name, {link.pose, "", link.element});
    }
    addWithChildren(tree_.root());
    readModelExtensions();
  }

  Model take() { return std::move(model_); }

private:
  void addWithChildren(const UrdfLink & link)
  {
    const std::optional<Inertia> inertia = link.joinedInertia();
    const bool is_world = link.name == "world";
    if (!is_world && (!inertia || std::abs(inertia->mass) < kLeastMass)) {
      leaveOut(link, link, link.isJoined());
      return;
    }
    if (!is_world && !link.isJoined()) {
      addLink(link, *inertia);
      addJoint(link);
    }
    for (const UrdfLink * const child : link.children) {
      addWithChildren(*child);
    }
  }

  /// @param is_elsewhere  whether the contents of the link are part of one that stays
  void leaveOut(const UrdfLink & link, const UrdfLink & without_mass, bool is_elsewhere)
  {
    if (!is_elsewhere && link.element.child("collision")) {
      link.element.fail(
        std::string("has a <collision>, but ") +
        (&link == &without_mass ? "no mass" : "hangs on '" + without_mass.name + "', which has no mass") +
        ", so that Gazebo leaves it out; needed is an <inertial> with a mass above 0");
    }
    if (!is_elsewhere) {
      warnings_.add("has no mass, or hangs on a link without, so that Gazebo leaves it out", link.element.fileLine());
    }
    for (const UrdfLink * const child : link.children) {
      leaveOut(*child, without_mass, is_elsewhere && child->isJoined());
    }
  }

  void addLink(const UrdfLink & link, const Inertia & inertia)
  {
    LinkPart part;
    part.element = link.element;
    part.name = link.name;
    part.pose = link.pose;
    part.inertia = inertia;
    warnOfInertia(link.element, inertia, warnings_);
    addSolids(link, link, part.solids);
    addVisuals(link, part.visuals);
    for (const Element & extension : extensions_.ofLink(link)) {
      addSensors(extension, part);
    }
    model_.links.push_back(std::move(part));
  }

  /// The collision elements of a link and of those that become part of it, counted together.
  void addSolids(const UrdfLink & link, const UrdfLink & whole, std::vector<Solid> & solids)
  {
    for (const Element & collision : link.element.children("collision")) {
      const Element geometry = collision.child("geometry");
      if (!geometry) {
        collision.fail("has no <geometry>");
      }
      std::optional<Shape> shape = readUrdfShape(geometry, meshes_);
      if (!shape) {
        continue;
      }
      Solid solid;
      solid.name = nameOf(collision, link, whole, solids.size());
      solid.shape = *std::move(shape);
      solid.pose = link.pose * readOrigin(collision);
      collision.requireNear(solid.pose.position);
      extensions_.apply(whole, solid, warnings_);
      solids.push_back(std::move(solid));
    }
    for (const UrdfLink * const child : link.children) {
      if (child->isJoined()) {
        addSolids(*child, whole, solids);
      }
    }
  }

  /// Likewise what is seen of them.
  void addVisuals(const UrdfLink & link, std::vector<Visual> & visuals)
  {
    for (const Element & visual : link.element.children("visual")) {
      const auto pose = [&] { return link.pose * readOrigin(visual); };
      visuals.push_back(readVisual(visual, pose, meshes_, extensions_.materialOf(link)));
    }
    for (const UrdfLink * const child : link.children) {
      if (child->isJoined()) {
        addVisuals(*child, visuals);
      }
    }
  }

  static std::string nameOf(const Element & collision, const UrdfLink & link, const UrdfLink & whole, std::size_t count)
  {
    const std::string own = collision.name().empty() ? link.name : collision.name();
    const std::string name = own + "_collision" + (count > 0 ? "_" + std::to_string(count) : "");
    return name.rfind(whole.name, 0) == 0 ? name : whole.name + "_fixed_joint_lump__" + name;
  }

  void addSensors(const Element & extension, LinkPart & part)
  {
    const Pose3 & link_pose = model_.link_poses.at(extension.attribute("reference"));
    for (const Element & sensor : extension.children("sensor")) {
      const GivenPose pose = readPose(sensor, "");
      part.sensors.push_back({sensor, pose.frame.empty() ? link_pose * pose.pose : model_.frames->resolved(pose)});
    }
    for (const Element & child : extension.children()) {
      if (kOfLinks.count(child.tag()) == 0) {
        warnings_.add("<" + child.tag() + "> of a link is left out", child.fileLine());
      }
    }
  }

  void addJoint(const UrdfLink & link)
  {
    if (!link.joint) {
      return;
    }
    if (link.joint->type == "floating" || link.joint->type == "planar") {
      warnings_.add(
        "a joint of type " + link.joint->type + " is left out: its link is held fast", link.joint->element.fileLine());
      return;
    }
    const UrdfJoint & given = *link.joint;
    JointPart joint;
    joint.element = given.element;
    joint.name = given.name;
    joint.type = given.type;
    joint.parent = link.parent->whole().name;
    joint.child = link.name;
    joint.pose = link.pose;
    if (given.type != "fixed") {
      readAxis(given.element, joint);
    }
    model_.joints.push_back(std::move(joint));
  }

  static void readAxis(const Element & element, JointPart & joint)
  {
    const Element axis = element.child("axis");
    const Eigen::Vector3d xyz =
      axis.has("xyz") ? axis.toVector("attribute 'xyz'", axis.attribute("xyz")) : Eigen::Vector3d::UnitX();
    if (!xyz.allFinite() || xyz.norm() == 0.0) {
      axis.fail("attribute 'xyz' is '" + axis.attribute("xyz") + "', which is no direction");
    }
    joint.axis = joint.pose.rotation * xyz;
    const Element limit = element.child("limit");
    if (!limit && joint.type != "continuous") {
      element.fail("has no <limit>, which a joint of type " + joint.type + " needs");
    }
    if (limit) {
      const double a = limit.numberAttribute("lower", 0.0);
      const double b = limit.numberAttribute("upper", 0.0);
      joint.lower = joint.type == "continuous" ? joint.lower : std::min(a, b);
      joint.upper = joint.type == "continuous" ? joint.upper : std::max(a, b);
      joint.effort = positiveOrInfinite(limit.numberAttribute("effort"));
      joint.velocity = positiveOrInfinite(limit.numberAttribute("velocity"));
    }
  }

  void readModelExtensions()
  {
    for (const Element & extension : extensions_.ofModel()) {
      // As in Gazebo, each such tag replaces the one before.
      model_.is_static = extension.child("static").value() == "true" || extension.child("static").value() == "1";
      for (const Element & child : extension.children()) {
        if (child.is("plugin")) {
          model_.plugins.push_back(child);
        } else if (!child.is("static") && kOfLinks.count(child.tag()) == 0) {
          warnings_.add("<" + child.tag() + "> of a robot is left out", child.fileLine());
        }
      }
    }
  }

  MeshLibrary & meshes_;
  WarningCollector & warnings_;
  UrdfTree tree_;
  UrdfExtensions extensions_;
  Model model_;
};
}  // namespace

Model readUrdf(const Element & robot, MeshLibrary & meshes, WarningCollector & warnings)
{
  return UrdfModel(robot, meshes, warnings).take();
}
}  // namespace f1tenth_sim2d
