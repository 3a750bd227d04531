"""The planner of f1tenth_racer on circuits and tracks, with the parameters of f1tenth_navigation."""

import numpy as np
import yaml
from f1tenth_judge.places.lookup import GAZEBO_PACKAGE, package_path
from f1tenth_judge.places.map_file import load_map

import f1tenth_sim2d
from f1tenth_bench.benchmark import NotAvailable
from f1tenth_bench.places import data_file

TRACKS = ("Austin", "Oschersleben", "Spielberg")
_STARTS = 6  # a track


def planner_module():
    """The Python module of the planner.

    Raises:
        NotAvailable: the original move_base is installed, and the stand-in is not built.
    """
    try:
        import f1tenth_racer_core
    except ImportError as error:
        raise NotAvailable(f"no f1tenth_racer: {error}") from error
    return f1tenth_racer_core


def load_costmap(path):
    """A map in map_server's format as the planner sees it."""
    core = planner_module()
    grid = load_map(path)
    inflation = _parameters("costmap_common.yaml")
    options = core.CostmapOptions(
        inflation_radius=inflation["inflation_radius"], cost_scaling_factor=inflation["cost_scaling_factor"]
    )
    return core.Costmap(grid.cells, grid.resolution, (grid.x, grid.y), options)


def race_options():
    """How the car races."""
    options = planner_module().RacerOptions
    values = _parameters("racer.yaml")["RacerROS"]
    known = {name: values[name] for name, *_ in options.table() if name in values}
    return options(dec_lim_x=values["acc_lim_x"], **known)


def half_laps(name):
    """The map of a circuit or track, and pairs of poses half a lap apart."""
    if name not in TRACKS:
        from f1tenth_judge.places.goals import read_goals

        gazebo = package_path(GAZEBO_PACKAGE)
        poses = np.array([(goal.x, goal.y, goal.yaw) for goal in read_goals(gazebo / f"goals/{name}.txt")])
        costmap = load_costmap(gazebo / f"maps/{name}.yaml")
        starts = range(len(poses))
    else:
        poses = _centreline(data_file(f"tracks/{name}/{name}_centerline.csv"))
        costmap = load_costmap(data_file(f"tracks/{name}/{name}_map.yaml"))
        starts = range(0, len(poses), len(poses) // _STARTS)
    return costmap, [(poses[i], poses[(i + len(poses) // 2) % len(poses)]) for i in starts]


def _parameters(name):
    return yaml.safe_load((package_path("f1tenth_navigation") / "config" / name).read_text())


def _centreline(path):
    line = f1tenth_sim2d.read_centreline(path)[:, :2]
    ahead = np.roll(line, -1, axis=0) - line
    return np.column_stack([line, np.arctan2(ahead[:, 1], ahead[:, 0])])
