#include "loaders/model/model.h"

#include <iterator>
#include <utility>

namespace f1tenth_sim2d
{
namespace
{
/// Moves the parts of a nested model into the frame of the one around it.
void move(Model & model, const Pose3 & pose)
{
  for (LinkPart & link : model.links) {
    link.pose = pose * link.pose;
    link.inertia = placed(link.inertia, pose);
    for (Solid & solid : link.solids) {
      solid.pose = pose * solid.pose;
    }
    for (Visual & visual : link.visuals) {
      visual.pose = pose * visual.pose;
    }
    for (SensorPart & sensor : link.sensors) {
      sensor.pose = pose * sensor.pose;
    }
  }
  for (JointPart & joint : model.joints) {
    joint.pose = pose * joint.pose;
    joint.axis = pose.rotation * joint.axis;
  }
  for (auto & [name, link_pose] : model.link_poses) {
    link_pose = pose * link_pose;
  }
}

void rename(Model & model)
{
  const std::string scope = model.name + "::";
  for (LinkPart & link : model.links) {
    link.name = scope + link.name;
  }
  for (JointPart & joint : model.joints) {
    joint.name = scope + joint.name;
    joint.parent = joint.parent == "world" ? joint.parent : scope + joint.parent;
    joint.child = scope + joint.child;
  }
}

template <typename T>
void append(std::vector<T> & parts, std::vector<T> more)
{
  parts.insert(parts.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// Where the frame of a model itself is, whichever of its frames its pose is that of.
GivenPose placeOf(const Model & model)
{
  GivenPose place = model.given_pose;
  place.pose = place.pose * model.frames->poseOf(model.placement_frame, model.element).inverse();
  return place;
}
}  // namespace

void nestFrames(Model & nested, FrameScope & frames, WarningCollector & warnings)
{
  const GivenPose place = placeOf(nested);
  const std::string given = nested.name;
  for (int number = 1; !frames.add(nested.name, place); ++number) {
    nested.name = given + "_" + std::to_string(number);
  }
  if (nested.name != given) {
    const Element & named_in = nested.include ? nested.include : nested.element;
    warnings.add("the name '" + given + "' is taken: called '" + nested.name + "' here", named_in.fileLine());
  }
  frames.addNested(nested.name, nested.frames);
}

Pose3 ownPose(const Model & model)
{
  return FrameScope().resolved(placeOf(model));
}

Inertia inertiaOf(const Model & model)
{
  Inertia sum;
  for (const LinkPart & link : model.links) {
    sum = &link == &model.links.front() ? link.inertia : sum + link.inertia;
  }
  return sum;
}

Model flattened(Model model)
{
  for (Model & each : std::exchange(model.models, {})) {
    Model inner = flattened(std::move(each));
    move(inner, inner.pose);
    rename(inner);
    model.root_link = model.root_link.empty() ? inner.name + "::" + inner.root_link : model.root_link;
    for (const auto & [name, pose] : inner.link_poses) {
      model.link_poses.emplace(inner.name + "::" + name, pose);
    }
    append(model.links, std::move(inner.links));
    append(model.joints, std::move(inner.joints));
    append(model.plugins, std::move(inner.plugins));
  }
  return model;
}
}  // namespace f1tenth_sim2d
