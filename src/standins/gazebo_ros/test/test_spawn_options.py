import pytest
from gazebo_ros.errors import UsageError
from gazebo_ros.spawn_model import database_file, initial_pose
from gazebo_ros.spawn_options import parse

LEAST = ["-urdf", "-param", "robot_description", "-model", "car"]


def test_defaults():
    options = parse(LEAST, "/ns/")
    assert (options.kind, options.param, options.model) == ("urdf", "robot_description", "car")
    assert (options.robot_namespace, options.reference_frame, options.gazebo_namespace) == (
        "/ns/",
        "",
        "/gazebo",
    )
    assert (options.x, options.y, options.z) == (0.0, 0.0, 0.0)
    assert (options.R, options.P, options.Y, options.joints) == (0.0, 0.0, 0.0, [])
    assert not options.unpause
    assert options.wait is None


def test_all_options_of_the_original():
    options = parse(
        ["-sdf", "-file", "/m.sdf", "-model", "m", "-x", "1", "-y", "-2.5", "-z", "0.1", "-R", "0", "-P", "0"]
        + ["-Y", "1.5", "-robot_namespace", "/r", "-reference_frame", "base", "-unpause", "-wait", "other"]
        + ["-J", "hinge", "0.5", "-b", "-package_to_model", "__name:=spawn"],
        "/",
    )
    assert (options.kind, options.file) == ("sdf", "/m.sdf")
    assert (options.x, options.y, options.z) == (1.0, -2.5, 0.1)
    assert (options.R, options.P, options.Y) == (0.0, 0.0, 1.5)
    assert (options.robot_namespace, options.reference_frame, options.wait) == ("/r", "base", "other")
    assert (options.unpause, options.bond, options.joints) == (True, True, [["hinge", "0.5"]])


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (LEAST[1:], "one of the arguments -urdf -sdf is required"),
        (["-urdf", "-model", "m"], "one of the arguments -param -file -database -stdin is required"),
        (LEAST[:-2], "the following arguments are required: -model"),
        ([*LEAST, "-x", "nan"], "argument -x: found 'nan', expected a finite number"),
        ([*LEAST, "-J", "hinge", "up"], "argument -J hinge: found 'up', expected a finite number"),
        ([*LEAST, "-colour", "red"], "unrecognized arguments: -colour red"),
    ],
)
def test_what_cannot_be_understood_is_refused(arguments, message):
    with pytest.raises(UsageError) as error:
        parse(arguments, "/")
    assert str(error.value) == message


def test_pose_of_the_options():
    pose = initial_pose(parse([*LEAST, "-x", "1", "-Y", "3.14159265"], "/"))
    assert pose.position.x == 1.0
    assert pose.orientation.z == pytest.approx(1.0)


def test_model_of_the_database_is_below_the_model_path(tmp_path):
    (tmp_path / "cone").mkdir()
    (tmp_path / "cone" / "model.sdf").touch()
    assert database_file("cone", {"GAZEBO_MODEL_PATH": f"/no:{tmp_path}"}) == f"{tmp_path}/cone/model.sdf"
    with pytest.raises(UsageError, match="^no model cube; looked in /no$"):
        database_file("cube", {"GAZEBO_MODEL_PATH": "/no"})
    with pytest.raises(UsageError, match="^no model cube; looked in GAZEBO_MODEL_PATH, which is empty$"):
        database_file("cube", {})
