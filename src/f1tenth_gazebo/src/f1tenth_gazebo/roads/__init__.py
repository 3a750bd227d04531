"""Random closed roads that can be driven: `make_road(seed, length=120.0)`; needs no ROS."""

from f1tenth_gazebo.roads.road import Road, make_road
from f1tenth_gazebo.roads.road_files import write_road
from f1tenth_gazebo.roads.road_options import RoadError, RoadOptions

__all__ = ["Road", "RoadError", "RoadOptions", "make_road", "write_road"]
