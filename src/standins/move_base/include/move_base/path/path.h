#pragma once

#include <vector>

#include "move_base/map/geometry.h"
#include "move_base/search/curves.h"

namespace move_base
{
struct PathPoint
{
  Pose2 pose;             ///< of the base frame, in the map
  double curvature{0.0};  ///< 1/m, of the wheels' setting: positive is steering to the left
  bool reverse{false};    ///< whether the car drives backwards from here to the next point
  double s{0.0};          ///< m driven since the start, backwards counting like forwards
};

/// A path for the base frame. Where the driving direction changes, two points lie at the same pose: the last one of
/// one direction and the first one of the other.
using Path = std::vector<PathPoint>;

/// Points [begin, end) of one driving direction.
struct PathStretch
{
  std::size_t begin;
  std::size_t end;
};

/// Splits a path where the driving direction changes.
std::vector<PathStretch> stretches(const Path & path);
/// Whether it is driven forwards all along.
bool isForward(const Path & path);

/// The path that arcs describe. Within one driving direction points are equally far apart, at most spacing, m.
Path samplePath(const Pose2 & start, const std::vector<Arc> & arcs, double spacing);

/// Signed curvature of the circle through three points, positive when it turns to the left, 1/m.
double curvatureThrough(const Vec2 & a, const Vec2 & b, const Vec2 & c);

/// Length driven, m.
double length(const Path & path);
double length(const std::vector<Arc> & arcs);

/// The point of a path nearest to a pose.
/// @param path  of at least one point
std::size_t nearestTo(const Path & path, const Pose2 & pose);

/// The first of its points, starting at an index, that is at a place or beyond it; the last one if none is.
/// @param path  of at least one point
/// @param s     m along it
std::size_t firstBeyond(const Path & path, double s, std::size_t from = 0);
}  // namespace move_base
