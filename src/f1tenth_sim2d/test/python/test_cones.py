"""A world that others made of mesh cones: a car sees them, and pushes one away."""

import os
from pathlib import Path

import pytest

import f1tenth_sim2d

DEFAULT_DATA = Path(__file__).parents[5] / "shared" / "data"
DATA = Path(os.environ.get("F1TENTH_DATA", DEFAULT_DATA))
CONES = DATA / "worlds" / "racecar_cones.world"


@pytest.mark.skipif(
    not CONES.exists(), reason=f"there is no {CONES}; F1TENTH_DATA names the folder of data made by others"
)
def test_cone_is_seen_where_it_is_and_pushed_away(car):
    simulation = f1tenth_sim2d.Simulation(f1tenth_sim2d.load_world(str(CONES)))
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
