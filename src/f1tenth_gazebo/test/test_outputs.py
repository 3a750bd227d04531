"""What a command is to write must have a name."""

import pytest
from f1tenth_gazebo.roads import road_tool

from f1tenth_gazebo import tools


@pytest.mark.parametrize("output", [".", "..", "/", "", "maps/.."])
@pytest.mark.parametrize(
    ("command", "arguments"),
    [
        (tools.make_world, ["circuit1.yaml"]),
        (tools.make_goals, ["circuit1.yaml"]),
        (tools.make_map, ["circuit1.world"]),
        (tools.make_centerline, ["circuit1.yaml"]),
        (road_tool.main, ["--seed", "8"]),
    ],
)
def test_output_without_a_name_is_refused(command, arguments, output, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit) as ended:
        command([*arguments, "-o", output])
    assert ended.value.code == 2
    assert capsys.readouterr().err.endswith(f"error: argument -o: found {output!r}, must end with a name\n")
