"""Cars for the benchmarks."""

from f1tenth_judge.places.lookup import package_path
from f1tenth_sim2d.environments.car import Lidar, with_lidar
from f1tenth_sim2d.environments.xacro_file import expanded

import f1tenth_sim2d

F1TENTH = Lidar(1081, 2 * 2.356194490192345, 10.0)
"""The lidar of the workspace's car."""
SPIELBERG = Lidar(1080, 2 * 2.35, 30.0)
"""The lidar with which the peers were measured."""

BARE_LIDAR = """<sdf version="1.7"><model name="lidar"><link name="base_footprint">
<collision name="bead"><pose>0 0 50 0 0 0</pose>
<geometry><sphere><radius>0.001</radius></sphere></geometry></collision>
<sensor name="lidar" type="ray"><pose>0 0 0.16 0 0 0</pose><update_rate>40</update_rate><ray>
  <scan><horizontal><samples/><min_angle/><max_angle/></horizontal></scan>
  <range><min>0</min><max/></range>
</ray>
<plugin name="laser" filename="libgazebo_ros_laser.so">
  <topicName>scan</topicName><frameName>laser</frameName>
</plugin></sensor></link></model></sdf>"""


def urdf_file():
    """Path of the description of the workspace's car."""
    return package_path("f1tenth_description") / "urdf/f1tenth.urdf.xacro"


def description(lidar):
    """Return the URDF of the workspace's car with another lidar."""
    return with_lidar(expanded(urdf_file()), lidar)


def f1tenth_car(lidar=F1TENTH, name="robot1"):
    """Return the workspace's car as the simulator knows it."""
    return f1tenth_sim2d.load_car(description(lidar), name, str(urdf_file()))


def simulation_of(world, places, lidar=F1TENTH):
    """Return a Simulation of a car, with this lidar, at each of these poses (x, y, yaw), m and rad."""
    simulation = f1tenth_sim2d.Simulation(world, seed=1)
    for i, place in enumerate(places, 1):
        simulation.add_car(f1tenth_car(lidar, f"robot{i}"), None, *place)
    return simulation


def bare_lidar(lidar):
    """Return a car that is only a lidar, 0.16 m above the ground, and touches nothing below 50 m."""
    return f1tenth_sim2d.load_car(with_lidar(BARE_LIDAR, lidar), "lidar", "bare lidar")
