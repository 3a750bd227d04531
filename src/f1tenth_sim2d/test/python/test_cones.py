"""Worlds of mesh cones: a car sees them, and pushes one away."""

import os
from pathlib import Path

import pytest

import f1tenth_sim2d

ROOT = Path(__file__).parents[4]
DATA = Path(os.environ.get("F1TENTH_DATA", ROOT.parent / "shared" / "data"))
WORLDS = [ROOT / "data" / "worlds" / "cones.world", DATA / "worlds" / "racecar_cones.world"]


@pytest.mark.parametrize("cones", [world for world in WORLDS if world.exists()], ids=lambda world: world.stem)
def test_cone_is_seen_where_it_is_and_pushed_away(car, cones):
    world = f1tenth_sim2d.load_world(str(cones), [str(cones.parents[1] / "gazebo_models")])
    simulation = f1tenth_sim2d.Simulation(world)
    simulation.add_car(car, None, -0.5, 0.0, 0.0)
    (lidar,) = car.lidars
    ahead = lidar.beam_count // 2
    before = simulation.model_pose("cone_1")
    distance = before[0] + 0.5 - lidar.pose[0]
    assert distance - 0.1 < simulation.scan(0, exact=True)[ahead] < distance
    while simulation.time < 1.5:
        simulation.command(0, speed=2.0, steering_angle=0.0)
        simulation.advance_to(simulation.time + 0.025)
    assert {contact.other_model for contact in simulation.contacts(0)} == {"cone_1"}
    after = simulation.model_pose("cone_1")
    assert after[0] > before[0] + 0.2
    gap = after[0] - simulation.state(0).x - lidar.pose[0]
    assert gap - 0.1 < simulation.scan(0, exact=True)[ahead] < gap
