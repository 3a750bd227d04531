"""Movable models that lie on a side turn as they lie, not as they would stand."""

import math

import pytest

import f1tenth_sim2d

RATE = 5.0  # rad/s


def room(tmp_path, pose, moments, size, centre="0 0 0"):
    """Return a simulation of a box of 2 kg, which is where its centre of mass is, in a model at a <pose>."""
    ixx, iyy, izz = moments
    inertia = f"<inertia><ixx>{ixx}</ixx><iyy>{iyy}</iyy><izz>{izz}</izz></inertia>"
    inertial = f"<inertial><pose>{centre} 0 0 0</pose><mass>2</mass>{inertia}</inertial>"
    geometry = f"<pose>{centre} 0 0 0</pose><geometry><box><size>{size}</size></box></geometry>"
    link = f"<link name='link'>{inertial}<collision name='collision'>{geometry}</collision></link>"
    model = f"<model name='box'><pose>{pose}</pose>{link}</model>"
    path = tmp_path / "room.world"
    path.write_text(f"<sdf version='1.6'><world name='room'>{model}</world></sdf>")
    return f1tenth_sim2d.Simulation(f1tenth_sim2d.load_world(str(path)))


def turned(simulation):
    """Return the yaw of a cube that was set spinning, after 0.2 s on the ground."""
    simulation.place_model("box", 0.0, 0.0, 0.0, yaw_rate=RATE)
    simulation.advance_to(0.2)
    return simulation.model_pose("box")[2]


@pytest.mark.parametrize("tilt", [f"{math.pi / 2} 0 0", f"0 {math.pi / 2} 0.3", f"{-math.pi / 2} 0 -2"])
def test_cube_turns_about_the_axis_that_is_upright(tmp_path, tilt):
    lying = turned(room(tmp_path, f"0 0 0.1 {tilt}", (0.1, 0.1, 0.01), "0.2 0.2 0.2"))
    upright = turned(room(tmp_path, "0 0 0.1 0 0 0", (0.1, 0.1, 0.1), "0.2 0.2 0.2"))
    assert upright > 0.7
    assert lying == pytest.approx(upright, rel=1e-3)


def test_pole_that_lies_turns_about_its_middle(tmp_path):
    pole = room(tmp_path, f"0 0 0.05 0 {math.pi / 2} 0", (0.2, 0.2, 0.001), "0.1 0.1 1.0", centre="0 0 0.5")
    # Its foot is at the origin, its middle, which stands still, 0.5 m ahead.
    pole.place_model("box", 0.0, 0.0, 0.0, v_y=-0.5 * RATE, yaw_rate=RATE)
    pole.advance_to(2.0)
    x, y, yaw = pole.model_pose("box")
    assert yaw > 0.2
    assert (x + 0.5 * math.cos(yaw), y + 0.5 * math.sin(yaw)) == pytest.approx((0.5, 0.0), abs=1e-3)
