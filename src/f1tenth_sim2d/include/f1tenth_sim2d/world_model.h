#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "f1tenth_sim2d/geometry.h"
#include "f1tenth_sim2d/visual.h"

/// What the loaders produce and the simulation consumes: plain data, no SDF, no Box2D, no ROS.
namespace f1tenth_sim2d
{
struct Box
{
  Eigen::Vector3d size{Eigen::Vector3d::Zero()};  ///< edge lengths, m
};
struct Cylinder
{
  double radius{0.0};  ///< m
  double length{0.0};  ///< m, along z, centred
};
struct Sphere
{
  double radius{0.0};  ///< m
};
/// A cylinder with a half sphere at each end.
struct Capsule
{
  double radius{0.0};  ///< m
  double length{0.0};  ///< m, along z, centred, without the half spheres
};
struct Ellipsoid
{
  Eigen::Vector3d radii{Eigen::Vector3d::Zero()};  ///< m, along x, y and z
};
/// Areas extruded along z from 0 to height: the polylines of SDF, the walls of a map. See extrude().
struct Polyline
{
  std::vector<Outline> outlines;      ///< m; clockwise around holes, so that matter is always to the left
  std::vector<ConvexPolygon> pieces;  ///< m; the same area in convex pieces
  double height{0.0};                 ///< m
};
/// The half space below z = 0 of its pose: the ground.
struct Plane
{
};
/// A surface: triangles with shared vertices, counter-clockwise seen from outside.
struct TriangleMesh
{
  std::vector<Eigen::Vector3d> vertices;  ///< m
  std::vector<std::array<std::uint32_t, 3>> triangles;
};
/// The surface of a mesh file. What it encloses is solid; where it is open it is a thin sheet.
struct Mesh
{
  std::shared_ptr<const TriangleMesh> surface;  ///< shared by all solids of one file and scale
};
using Shape = std::variant<Box, Cylinder, Sphere, Capsule, Ellipsoid, Polyline, Plane, Mesh>;

/// One collision element.
struct Solid
{
  std::string name;  ///< scoped name, "model::link::collision"
  Shape shape;
  Pose3 pose;      ///< in the frame of the model
  double mu{1.0};  ///< Coulomb friction coefficient
  double restitution{0.0};
};

/// One rigid model of the world. A model of several links counts as one rigid body in its start configuration.
struct ModelDescription
{
  std::string name;  ///< unique in the world; nested models are "outer::inner"
  Pose3 pose;        ///< in the world
  bool is_static{false};
  double mass{0.0};        ///< kg, all links
  double inertia_zz{0.0};  ///< kg m^2, about the vertical through the centre of mass
  Vec2 centre_of_mass;     ///< m, seen from above: relative to pose, along its heading and to the left
  std::vector<Solid> solids;
  std::vector<Visual> visuals;
};

struct WorldDescription
{
  std::string file;  ///< where it came from
  std::string name;
  double gravity{9.8};  ///< m/s^2, downwards
  Pose2 start;          ///< where a car starts unless told otherwise; that of a race track is on its centreline
  std::vector<ModelDescription> models;
  std::vector<std::string> warnings;  ///< what cannot be represented: one entry per kind, with its element path
};
}  // namespace f1tenth_sim2d
