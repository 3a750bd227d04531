#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include "amcl/geometry.h"
#include "fit_field.h"

namespace amcl
{
/// Where a car that is lost may be: the centres (m) of all free cells that can be reached from a place. If that place
/// is not free itself, of all free cells: a map of a road is often free outside of the walls, too.
/// @param place  in the frame of MRPT's map
Points roadAbout(const mrpt::maps::COccupancyGridMap2D & map, const Pose2 & place);
}  // namespace amcl
