#pragma once

#include <move_base/map/geometry.h>

/// The racer speaks of poses, costmaps, paths and commands in the terms of move_base.
namespace f1tenth_racer
{
using namespace move_base;
}  // namespace f1tenth_racer
