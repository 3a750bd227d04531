#include "loaders/world/saved_state.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "loaders/frames/read_pose.h"

namespace f1tenth_sim2d
{
namespace
{
using Eigen::Vector3d;

/// Poses are saved with six digits: what differs by less than this has not moved, m and rad.
constexpr double kRounding = 1e-3;

Vector3d readScale(const Element & saved)
{
  const Vector3d scale = saved.vector("scale", Vector3d::Ones());
  if (!scale.allFinite() || scale.minCoeff() < 0.0) {
    saved.fail("<scale> is '" + saved.child("scale").text() + "', allowed are three finite numbers from 0");
  }
  return scale;
}

Mesh scaled(const Element & saved, const Mesh & mesh, const Vector3d & scale)
{
  auto surface = std::make_shared<TriangleMesh>(*mesh.surface);
  for (Vector3d & vertex : surface->vertices) {
    vertex = vertex.cwiseProduct(scale);
    saved.child("scale").requireNear(vertex);
  }
  return {std::move(surface)};
}

void requireLengths(const Element & saved, const Vector3d & lengths)
{
  for (const double length : lengths) {
    saved.child("scale").requireLength("a length that it makes", length);
  }
}

/// As Gazebo scales shapes, which keep their poses in the link; false if it cannot scale this one.
bool scaleShape(const Element & saved, const Vector3d & scale, Shape & shape)
{
  if (auto * const box = std::get_if<Box>(&shape)) {
    box->size = box->size.cwiseProduct(scale);
    requireLengths(saved, box->size);
  } else if (auto * const cylinder = std::get_if<Cylinder>(&shape)) {
    cylinder->radius *= std::max(scale.x(), scale.y());
    cylinder->length *= scale.z();
    requireLengths(saved, {cylinder->radius, cylinder->length, cylinder->length});
  } else if (auto * const sphere = std::get_if<Sphere>(&shape)) {
    sphere->radius *= scale.maxCoeff();
    requireLengths(saved, Vector3d::Constant(sphere->radius));
  } else if (auto * const mesh = std::get_if<Mesh>(&shape)) {
    *mesh = scaled(saved, *mesh, scale);
  } else {
    return false;
  }
  return true;
}

void scaleLinks(const Element & saved, Model & model, WarningCollector & warnings)
{
  const Vector3d scale = readScale(saved);
  if (scale.minCoeff() == 0.0) {
    warnings.add("a model with a <scale> of 0 has no collisions", saved.fileLine());
    for (LinkPart & link : model.links) {
      link.solids.clear();
      link.visuals.clear();
    }
    return;
  }
  for (LinkPart & link : model.links) {
    for (Solid & solid : link.solids) {
      if (scale != Vector3d::Ones() && !scaleShape(saved, scale, solid.shape)) {
        warnings.add(
          "<scale> of a <state> is applied to boxes, cylinders, spheres and meshes only, as in Gazebo",
          saved.child("scale").fileLine());
      }
    }
  }
}

bool isSame(const Pose3 & a, const Pose3 & b)
{
  const double turn = 2.0 * (a.rotation.conjugate() * b.rotation).vec().norm();  // of a small one, rad
  return (a.position - b.position).norm() < kRounding && turn < kRounding;
}

void moveLink(const Element & saved, const Pose3 & pose, LinkPart & link)
{
  saved.requireNear(pose.position);
  if (isSame(pose, link.pose)) {
    return;
  }
  const Pose3 change = pose * link.pose.inverse();
  link.pose = pose;
  link.inertia = placed(link.inertia, change);
  for (Solid & solid : link.solids) {
    solid.pose = change * solid.pose;
    saved.requireNear(solid.pose.position);
  }
  for (Visual & visual : link.visuals) {
    visual.pose = change * visual.pose;
  }
}

/// The part of a model that a saved element is about; null if the model has none of this name.
template <typename Part>
Part * partOf(std::vector<Part> & parts, const Element & saved)
{
  const auto found =
    std::find_if(parts.begin(), parts.end(), [&saved](const Part & part) { return part.name == saved.name(); });
  return found == parts.end() || !saved.child("pose") ? nullptr : &*found;
}
}  // namespace

std::map<std::string, Element> savedModels(const Element & world, WarningCollector & warnings)
{
  std::map<std::string, Element> models;
  const Element state = world.child("state");
  for (const Element & model : state.children("model")) {
    models.emplace(model.name(), model);
  }
  for (const char * const change : {"insertions", "deletions"}) {
    if (const Element changed = state.child(change); changed && !changed.children().empty()) {
      warnings.add(std::string("<") + change + "> of a <state> are left out", changed.fileLine());
    }
  }
  return models;
}

void restore(const Element & saved, Pose3 & pose, Model & model, WarningCollector & warnings)
{
  pose = saved.child("pose") ? readPose(saved, "").pose : pose;
  scaleLinks(saved, model, warnings);
  for (const Element & link : saved.children("link")) {
    if (LinkPart * const part = partOf(model.links, link)) {
      moveLink(link, pose.inverse() * readPose(link, "").pose, *part);
    }
  }
  for (const Element & nested : saved.children("model")) {
    if (Model * const part = partOf(model.models, nested)) {
      Pose3 place;
      restore(nested, place, *part, warnings);
      part->pose = pose.inverse() * place;
    }
  }
}
}  // namespace f1tenth_sim2d
