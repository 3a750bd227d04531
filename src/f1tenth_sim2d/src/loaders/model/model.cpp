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
}  // namespace

void nestFrames(const Model & nested, FrameScope & frames)
{
  GivenPose place = nested.given_pose;
  place.pose = place.pose * nested.frames->poseOf(nested.placement_frame, nested.element).inverse();
  if (!frames.add(nested.name, place)) {
    nested.element.fail("this name is taken; names are unique among the elements of one parent");
  }
  frames.addNested(nested.name, nested.frames);
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
