"""The node map_server: a map file as a latched topic and as services."""

import sys
import threading

import rospy
from nav_msgs.msg import MapMetaData, OccupancyGrid
from nav_msgs.srv import GetMap, GetMapResponse, LoadMap, LoadMapResponse

from map_server.conversions import to_occupancy_grid
from map_server.errors import MapError, MapImageError, MapMetadataError, MapNotFoundError
from map_server.map_io import load_map
from map_server.metadata import metadata_from, read_metadata
from map_server.urls import path_of

USAGE = """usage: map_server MAP.yaml
  MAP.yaml: description of the map
deprecated usage: map_server IMAGE RESOLUTION
  IMAGE: the map's image
  RESOLUTION: edge length of a pixel, m"""
EXIT_FAILURE = 255

_RESULTS = {
    MapNotFoundError: LoadMapResponse.RESULT_MAP_DOES_NOT_EXIST,
    MapImageError: LoadMapResponse.RESULT_INVALID_MAP_DATA,
    MapMetadataError: LoadMapResponse.RESULT_INVALID_MAP_METADATA,
}


class MapServerNode:
    """Publishes one map, latched, and swaps it on request."""

    def __init__(self, metadata, frame_id):
        """Load and publish the map. Raises MapError."""
        self._frame_id = frame_id
        self._lock = threading.Lock()
        self._message = self._load(metadata)
        self._metadata_publisher = rospy.Publisher("map_metadata", MapMetaData, latch=True, queue_size=1)
        self._map_publisher = rospy.Publisher("map", OccupancyGrid, latch=True, queue_size=1)
        self._services = [
            rospy.Service("static_map", GetMap, self._on_static_map),
            rospy.Service("change_map", LoadMap, self._on_change_map),
        ]
        self._publish()

    def _load(self, metadata):
        rospy.loginfo("Loading the map %s", metadata.image)
        if metadata.unknown_keys:
            rospy.logwarn("Keys without meaning in a map file: %s", ", ".join(metadata.unknown_keys))
        grid = load_map(metadata)
        rospy.loginfo("Read a map of %d x %d cells of %.3f m", grid.width, grid.height, grid.resolution)
        # Not waiting for a valid clock: a simulated clock may start only when all nodes have the map.
        return to_occupancy_grid(grid, self._frame_id, rospy.Time.now())

    def _publish(self):
        self._metadata_publisher.publish(self._message.info)
        self._map_publisher.publish(self._message)

    def _on_static_map(self, _request):
        with self._lock:
            return GetMapResponse(map=self._message)

    def _on_change_map(self, request):
        try:
            path = path_of(request.map_url)
            with self._lock:
                self._message = self._load(read_metadata(path))
                self._publish()
                return LoadMapResponse(map=self._message, result=LoadMapResponse.RESULT_SUCCESS)
        except MapError as error:
            rospy.logerr("The map stays as it is: %s", error)
            return LoadMapResponse(result=_RESULTS[type(error)])


def _metadata(arguments):
    if len(arguments) == 1:
        return read_metadata(arguments[0])
    rospy.logwarn("map_server IMAGE RESOLUTION is deprecated: write a YAML file beside the image")
    image, resolution = arguments
    values = {"image": image, "resolution": resolution, "origin": [0.0, 0.0, 0.0]}
    for key, default in (("negate", 0), ("occupied_thresh", 0.65), ("free_thresh", 0.196)):
        values[key] = rospy.get_param(f"~{key}", default)
    return metadata_from(values, "arguments")


def _frame_id():
    frame_id = rospy.get_param("~frame_id", "map")
    if not (isinstance(frame_id, str) and frame_id):
        place = rospy.resolve_name("~frame_id")
        raise MapError(f"parameter {place}: found {frame_id!r}, allowed is the name of a frame")
    return frame_id


def main(argv=None):
    """Run the node; return its exit code."""
    arguments = rospy.myargv(argv or sys.argv)[1:]
    if len(arguments) not in (1, 2):
        print(USAGE, file=sys.stderr)
        return EXIT_FAILURE
    rospy.init_node("map_server", anonymous=True)
    try:
        # The services live as long as this reference.
        node = MapServerNode(_metadata(arguments), _frame_id())  # noqa: F841
    except MapError as error:
        rospy.logfatal("%s", error)
        return EXIT_FAILURE
    rospy.spin()
    return 0
