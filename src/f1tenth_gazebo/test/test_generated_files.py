"""The shipped worlds, maps and goals must be what the tools make of the circuits."""

import numpy as np
import pytest
import shipped
import yaml
from f1tenth_gazebo.maps.occupancy import FREE, OCCUPIED
from f1tenth_gazebo.maps.world_grid import world_grid
from f1tenth_gazebo.tools import make_goals, make_map, make_world
from f1tenth_judge.errors import CircuitError
from PIL import Image
from shapely.geometry import Point


@pytest.mark.parametrize("name", shipped.NAMES)
class TestShippedFiles:
    def test_world_is_made_from_the_circuit(self, name, tmp_path):
        assert (
            make_world([str(shipped.PACKAGE / f"circuits/{name}.yaml"), "-o", str(tmp_path / "w.world")]) == 0
        )
        for suffix in (".world", "_centerline.csv"):
            expected = shipped.PACKAGE / f"worlds/{name}{suffix}"
            assert (tmp_path / f"w{suffix}").read_text() == expected.read_text()

    def test_centreline_is_the_circuit_s_with_a_point_at_least_every_0_3_m(self, name):
        x, y, right, left = np.loadtxt(shipped.PACKAGE / f"worlds/{name}_centerline.csv", delimiter=",").T
        steps = np.hypot(np.diff(x, append=x[0]), np.diff(y, append=y[0]))
        assert steps.min() > 0.0
        assert steps.max() <= 0.3001
        assert steps.sum() == pytest.approx(shipped.lap(name).length, abs=0.01)
        assert (right == left).all()

    def test_goals_are_made_from_the_circuit(self, name, tmp_path):
        assert make_goals([str(shipped.PACKAGE / f"circuits/{name}.yaml"), "-o", str(tmp_path / "g")]) == 0
        assert (tmp_path / "g").read_text() == (shipped.PACKAGE / f"goals/{name}.txt").read_text()

    def test_map_is_made_from_the_world(self, name, tmp_path):
        assert make_map([str(shipped.PACKAGE / f"worlds/{name}.world"), "-o", str(tmp_path / name)]) == 0
        for suffix in (".pgm", ".yaml"):
            assert (tmp_path / name).with_suffix(suffix).read_bytes() == (
                (shipped.PACKAGE / f"maps/{name}").with_suffix(suffix).read_bytes()
            )

    def test_map_agrees_with_the_section_of_the_world(self, name):
        """Measured with another library than the one that made it."""
        origin = yaml.safe_load((shipped.PACKAGE / f"maps/{name}.yaml").read_text())["origin"]
        pixels = np.asarray(Image.open(shipped.PACKAGE / f"maps/{name}.pgm"))[::-1]
        solid = shipped.solid(name)
        cells = np.random.default_rng(1).integers((0, 0), pixels.shape, size=(1500, 2))
        for row, column in cells:
            centre = Point(origin[0] + (column + 0.5) * 0.05, origin[1] + (row + 0.5) * 0.05)
            if pixels[row, column] == OCCUPIED:
                assert solid.distance(centre) < 0.036
            elif pixels[row, column] == FREE:
                assert solid.distance(centre) > 0.014


def test_readme_lists_the_circuits():
    expected = {}
    for name in shipped.NAMES:
        widths = [corner.width for corner in shipped.circuit(name).corners]
        road = f"{min(widths)}-{max(widths)}" if min(widths) < max(widths) else f"{widths[0]}"
        expected[f"`{name}`"] = [f"{shipped.lap(name).length:.0f}", road]
    readme = (shipped.PACKAGE / "README.md").read_text()
    table = readme.split("| circuit | lap (m) | road (m) |")[1].split("\n\n")[0]
    rows = [[cell.strip() for cell in line.split("|")[1:4]] for line in table.splitlines()[2:]]
    assert expected
    assert {name: cells for name, *cells in rows} == expected


def test_a_wrong_circuit_ends_in_one_line_and_exit_code_1(tmp_path, capsys):
    (tmp_path / "bad.yaml").write_text("corners: 3\n")
    assert make_world([str(tmp_path / "bad.yaml"), "-o", str(tmp_path / "w")]) == 1
    assert capsys.readouterr().err == f"{tmp_path}/bad.yaml:1: corners must be a list, found '3'\n"
    assert not (tmp_path / "w").exists()


def test_a_missing_world_ends_in_one_line_and_exit_code_1(tmp_path, capsys):
    assert make_map([str(tmp_path / "none.world"), "-o", str(tmp_path / "m")]) == 1
    error = capsys.readouterr().err
    assert "none.world" in error
    assert error.count("\n") == 1


def test_an_unwritable_output_ends_in_one_line_and_exit_code_1(tmp_path, capsys):
    circuit = str(shipped.PACKAGE / "circuits/circuit1.yaml")
    assert make_goals([circuit, "-o", str(tmp_path / "none" / "g")]) == 1
    assert "No such file" in capsys.readouterr().err


def test_a_world_that_is_not_closed_is_named():
    """At this height its windows are open."""
    with pytest.raises(CircuitError, match="circuit_detailed.world: the walls around .* have a gap"):
        world_grid(shipped.PACKAGE / "worlds/circuit_detailed.world", height=1.6)


def test_a_height_above_everything_is_refused():
    with pytest.raises(CircuitError, match="circuit1.world: nothing is solid at this height"):
        world_grid(shipped.PACKAGE / "worlds/circuit1.world", height=2.6)


def test_folder_that_is_not_there_is_named(tmp_path, capsys):
    world = tmp_path / "none" / "w.world"
    assert make_world([str(shipped.PACKAGE / "circuits/circuit1.yaml"), "-o", str(world)]) == 1
    assert capsys.readouterr().err == f"{world}: cannot be written: No such file or directory\n"
