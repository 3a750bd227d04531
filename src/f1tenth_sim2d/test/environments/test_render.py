"""What the pictures of the environments show, by the colours of their pixels."""

import signal
import subprocess
import sys

import numpy as np
import pytest
from conftest import straight_on
from f1tenth_sim2d.environments.ground import PAPER, ROAD, WALL, Ground
from f1tenth_sim2d.environments.picture import CARS, TRAIL
from f1tenth_sim2d.environments.place import find_place
from f1tenth_sim2d.f110_gym import F110Env
from PIL import Image

OPEN = """<sdf version="1.6"><world name="w"><model name="post"><static>1</static><pose>3 0 0 0 0 0</pose>
<link name="l"><collision name="c"><geometry><cylinder><radius>0.5</radius><length>1</length></cylinder>
</geometry></collision></link></model></world></sdf>"""
YAML = """image: ring.png
resolution: 0.05
origin: [-6, -1, 0]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.196
"""


def ring(folder, is_solid, scale=1, has_centreline=True):
    """A map of a road of 2 m around a rectangle; its walls are thin, or all is wall beside the road."""
    pixels = np.full((160, 240 * scale), 254, np.uint8)
    rows, columns = np.indices(pixels.shape)
    edge = np.minimum.reduce([rows, columns, pixels.shape[0] - 1 - rows, pixels.shape[1] - 1 - columns])
    walls = (edge < 4) | (edge > 44) if is_solid else (edge == 3) | (edge == 44)
    pixels[walls] = 0
    Image.fromarray(pixels).save(folder / "ring.png")
    (folder / "ring.yaml").write_text(YAML)
    if has_centreline:
        right, corners = 240 * scale * 0.05 - 7.2, [(-4.8, 0.2), (0, 0.2), (0, 5.8), (-4.8, 5.8)]
        corners = [(x if x < 0 else right, y) for x, y in corners]
        lines = [np.linspace(a, b, 40, endpoint=False) for a, b in zip(corners, corners[1:] + corners[:1])]
        np.savetxt(
            folder / "ring_centerline.csv",
            [(*each, 1.0, 1.0) for line in lines for each in line],
            delimiter=",",
        )
    return folder / "ring.yaml"


def colour(place, picture, point, car=(0.0, 0.0)):
    """Colour of the picture at a point, m; the first car is at `car`."""
    ground = Ground.of(place)
    corner = ground.corner(*car)
    x, y = ground.pixels(np.array([point]))[0]
    return tuple(int(each) for each in picture[int(y - corner[1]), int(x - corner[0])])


def shown(make, place, start=(0.0, 0.0, 0.0)):
    environment = make(place=place, render_mode="rgb_array")
    environment.reset(seed=1, options={"poses": [start]})
    return environment.render(), find_place(place)


@pytest.mark.parametrize("is_solid", [True, False], ids=["solid", "thin walls"])
@pytest.mark.parametrize("has_centreline", [True, False], ids=["centreline", "alone"])
def test_road_infield_and_wall_of_a_map_differ(make, tmp_path, is_solid, has_centreline):
    path = ring(tmp_path, is_solid, has_centreline=has_centreline)
    picture, place = shown(make, path, (0.0, 0.4, 0.0))
    assert colour(place, picture, (2.0, 0.5)) == ROAD
    assert colour(place, picture, (-4.5, 3.5)) == ROAD
    assert colour(place, picture, (0.0, 3.0)) == (WALL if is_solid else PAPER)
    assert colour(place, picture, (0.0, -0.825)) == WALL
    assert colour(place, picture, (0.0, 0.4)) == CARS[0]


def test_road_infield_and_wall_of_a_circuit_differ(make):
    picture, place = shown(make, "circuit1")
    x, y, right, left = place.centreline[len(place.centreline) // 4]
    assert colour(place, picture, (x + 0.3, y + 0.3)) == ROAD
    middle = place.centreline[:, :2].mean(axis=0)
    assert colour(place, picture, middle) == PAPER
    assert (picture == WALL).all(axis=2).mean() > 0.02
    assert colour(place, picture, (0.0, 0.0)) == CARS[0]


def test_an_open_world_has_no_road(make, tmp_path):
    (tmp_path / "open.world").write_text(OPEN)
    picture, place = shown(make, tmp_path / "open.world")
    assert colour(place, picture, (1.5, 0.0)) == PAPER
    assert colour(place, picture, (3.0, 0.0)) == WALL
    assert colour(place, picture, (0.0, 0.0)) == CARS[0]
    assert not (picture == ROAD).all(axis=2).any()


def test_a_large_place_is_shown_around_the_car(make, tmp_path):
    path = ring(tmp_path, False, scale=6)
    for x in (0.0, 40.0):
        picture, place = shown(make, path, (x, 0.4, 0.0))
        assert max(picture.shape) == 800
        assert colour(place, picture, (x, 0.4), (x, 0.4)) == CARS[0]
        assert colour(place, picture, (x + 3.0, 0.4), (x, 0.4)) == ROAD


def test_heading_trail_and_numbers_are_shown(make):
    environment = make(render_mode="rgb_array")
    environment.reset(seed=1)
    first = environment.render()
    place = find_place("circuit1")
    assert colour(place, first, (0.36, 0.0)) == (255, 255, 255)
    assert colour(place, first, (-0.05, 0.0)) == CARS[0]
    for _ in range(60):
        environment.step(straight_on())
    second = environment.render()
    assert colour(place, second, (1.0, 0.0)) == TRAIL
    assert (first[:20, :180] != second[:20, :180]).any()
    environment.reset(seed=1)
    np.testing.assert_array_equal(environment.render(), first)


def test_the_window_of_the_drop_in_shows_the_same(tmp_path):
    pygame = pytest.importorskip("pygame")
    environment = F110Env(map=str(ring(tmp_path, True).with_suffix("")), map_ext=".png", num_agents=1)
    environment.reset(np.array([[0.0, 0.4, 0.0]]))
    environment.render()
    picture = pygame.surfarray.array3d(pygame.display.get_surface()).swapaxes(0, 1)
    place = find_place(tmp_path / "ring.yaml")
    assert colour(place, picture, (2.0, 0.5)) == ROAD
    assert colour(place, picture, (0.0, 3.0)) == WALL
    environment.close()


def test_window_is_closed_by_its_button_and_driving_goes_on(make):
    pygame = pytest.importorskip("pygame")
    environment = make(render_mode="human")
    environment.reset(seed=1)
    assert pygame.display.get_init()
    pygame.event.post(pygame.event.Event(pygame.QUIT))
    for _ in range(2):
        environment.step(straight_on())
    assert not pygame.display.get_init()
    environment.close()


PATIENCE = 60.0  # wall s
ENDLESS = """import gymnasium, f1tenth_sim2d.environments as e
e.register()
environment = gymnasium.make(e.ENVIRONMENT, place="circuit1", beams=20, render_mode="human")
environment.reset(seed=1)
print("shown", flush=True)
while True:
    environment.reset(seed=1)
"""


def test_process_with_a_window_ends_by_sigterm():
    pytest.importorskip("pygame")
    with subprocess.Popen([sys.executable, "-c", ENDLESS], stdout=subprocess.PIPE, text=True) as process:
        try:
            assert process.stdout.readline().strip().endswith("shown")
            process.terminate()
            assert process.wait(PATIENCE) == -signal.SIGTERM
        finally:
            process.kill()
