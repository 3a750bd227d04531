import pytest
from gazebo_ros.errors import UsageError
from gazebo_ros.server_options import find_world, parse, resource_folders


def test_without_arguments_the_world_is_empty():
    options, left_out = parse([])
    assert (options.world, options.pause, options.seed) == ("worlds/empty.world", False, None)
    assert left_out == []


def test_arguments_of_the_original_launch_file():
    options, left_out = parse(["-u", "-e", "ode", "--verbose", "--seed", "7", "/a/b.world", "__name:=gazebo"])
    assert (options.world, options.pause, options.seed) == ("/a/b.world", True, 7)
    assert left_out == []


def test_profile_is_the_name_of_a_physics():
    assert parse(["--profile", "fast"])[0].profile == "fast"
    assert parse(["-o", "fast"])[0].profile == "fast"


def test_options_without_effect_are_named():
    _, left_out = parse(["-s", "libgazebo_ros_api_plugin.so", "--record", "w.world"])
    assert left_out == ["server_plugin", "record"]


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["--seed", "x"], "--seed: found 'x', expected a whole number from 0 to 2147483647"),
        (
            ["--seed", "2147483648"],
            "--seed: found '2147483648', expected a whole number from 0 to 2147483647",
        ),
        (["--no-such"], "unrecognized arguments: --no-such"),
        (["a.world", "b.world"], "unrecognized arguments: b.world"),
    ],
)
def test_what_cannot_be_understood_is_refused(arguments, message):
    with pytest.raises(UsageError) as error:
        parse(arguments)
    assert str(error.value) == message


def test_world_is_found_in_folders_in_order(tmp_path):
    for name in ("one", "two"):
        (tmp_path / name / "worlds").mkdir(parents=True)
        (tmp_path / name / "worlds" / "w.world").touch()
    folders = [str(tmp_path / "one"), str(tmp_path / "two")]
    assert find_world("worlds/w.world", folders) == f"{tmp_path}/one/worlds/w.world"
    assert find_world(f"{tmp_path}/two/worlds/w.world", []) == f"{tmp_path}/two/worlds/w.world"


def test_world_that_is_missing_is_named_with_the_folders():
    with pytest.raises(UsageError) as error:
        find_world("worlds/no.world", ["/a", "/b"])
    assert str(error.value) == "no world worlds/no.world; looked here and in /a, /b"


def test_own_worlds_come_last():
    assert resource_folders({"GAZEBO_RESOURCE_PATH": "/a::/b"}, "/own") == ["/a", "/b", "/own"]
    assert resource_folders({}, "/own") == ["/own"]
