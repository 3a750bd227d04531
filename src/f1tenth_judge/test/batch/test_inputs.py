"""What makes an old result count no more."""

import shutil

import pytest
from f1tenth_judge.batch import inputs
from f1tenth_judge.batch.inputs import hash_inputs, hash_software
from f1tenth_judge.places import lookup
from f1tenth_judge.plan.planning import make_plan


@pytest.fixture
def scenario(tmp_path):
    """A scenario of which every file lies in a folder of its own; gives the folder."""
    world = lookup.world_file("circuit1", tmp_path)
    map_file = lookup.map_file(world)
    for file in (world, map_file, map_file.with_suffix(".pgm"), lookup.goals_file("circuit1", tmp_path)):
        shutil.copy(file, tmp_path)
    (tmp_path / "line.csv").write_text("0,0,1,1\n1,0,1,1\n0,1,1,1\n", encoding="utf-8")
    (tmp_path / "own.yaml").write_text(
        "description: d\nworld: ./circuit1.world\ncourse: ./line.csv\ncriteria: {off_road: 9.0}\n"
        "cars:\n  - {name: robot1, goals: ./circuit1.txt}\n"
        "  - {name: robot2, driver: pursuit, line: ./line.csv}\n"
        "limits: {timeout: 9.0}\nexpected: success\nseed: 1\n",
        encoding="utf-8",
    )
    return tmp_path


def hashed(folder, *settings, software="s"):
    return hash_inputs(make_plan(str(folder / "own.yaml"), settings=settings), software)


@pytest.mark.parametrize(
    ("name", "end"),
    [
        ("own.yaml", "# more\n"),
        ("circuit1.world", "<!-- more -->\n"),
        ("circuit1.yaml", "# more\n"),
        ("circuit1.pgm", " "),
        ("circuit1.txt", "# more\n"),
        ("line.csv", "# more\n"),
    ],
)
def test_a_file_that_the_scenario_names_changes_the_hash(scenario, name, end):
    before = hashed(scenario)
    assert hashed(scenario) == before
    with open(scenario / name, "a", encoding="utf-8") as stream:
        stream.write(end)
    assert hashed(scenario) != before


@pytest.mark.parametrize("name", ["mine/my.launch", "mine/line.csv", "mine/planner.py"])
def test_what_a_planner_of_no_package_reads_changes_the_hash(scenario, name):
    (scenario / "mine").mkdir()
    launch = scenario / "mine" / "my.launch"
    launch.write_text('<launch><arg name="waypoints"/></launch>', encoding="utf-8")
    (scenario / "mine" / "planner.py").touch()
    shutil.copy(scenario / "line.csv", scenario / "mine")
    file = scenario / "own.yaml"
    driver = "{launch: mine/my.launch, arguments: {waypoints: mine/line.csv}}"
    text = file.read_text(encoding="utf-8").replace("pursuit, line: ./line.csv", driver)
    file.write_text(text, encoding="utf-8")
    before = hashed(scenario)
    (scenario / "results").mkdir()
    (scenario / "results" / "of_a_run.csv").touch()
    assert hashed(scenario) == before
    with open(scenario / name, "a", encoding="utf-8") as stream:
        stream.write("\n")
    assert hashed(scenario) != before


@pytest.fixture
def planners(scenario):
    """A scenario whose car is driven by a class, beside which others and their outputs lie."""
    folder = scenario / "mine"
    (folder / "control" / "gains").mkdir(parents=True)
    (folder / "planner.py").write_text(
        "import numpy\nfrom helper import limits\n\nimport control.speed\n\nopen(f'{__file__}_line.csv')\n"
    )
    for name in ("helper", "limits", "other", "control/__init__", "control/unused"):
        (folder / f"{name}.py").touch()
    (folder / "control" / "speed.py").write_text("from .gains import gain\n")
    (folder / "control" / "gains" / "__init__.py").write_text("import limits\n")
    for name in ("control/gains/gain.py", "my_line.csv", "cup.yaml", "out.log", "output"):
        (folder / name).touch()
    file = scenario / "own.yaml"
    text = file.read_text(encoding="utf-8")
    first, second = text.index("  - {name: robot1"), text.index("limits:")
    car = "  - {name: robot1, laps: 1, driver: {python: 'mine/planner.py:Mine'}}\n"
    file.write_text(text[:first] + car + text[second:])
    return scenario


USED = ["planner.py", "helper.py", "limits.py", "control/speed.py", "control/gains/gain.py", "my_line.csv"]


@pytest.mark.parametrize(
    ("name", "counts"),
    [
        *((name, True) for name in USED),
        *((name, False) for name in ("other.py", "control/unused.py", "cup.yaml", "out.log", "output")),
    ],
)
def test_of_what_lies_beside_a_class_only_what_it_uses_changes_the_hash(planners, name, counts):
    before = hashed(planners)
    (planners / "mine" / name).write_text("# more\n", encoding="utf-8")
    assert (hashed(planners) != before) == counts


def test_a_class_that_cannot_be_parsed_changes_the_hash(planners):
    before = hashed(planners)
    (planners / "mine" / "planner.py").write_text("class Mine(\n", encoding="utf-8")
    assert hashed(planners) != before


def test_what_a_command_prints_beside_a_launch_file_does_not_change_the_hash(scenario):
    (scenario / "my.launch").write_text("<launch/>", encoding="utf-8")
    file = scenario / "own.yaml"
    text = file.read_text(encoding="utf-8")
    file.write_text(text.replace("pursuit, line: ./line.csv", "{launch: my.launch}"), encoding="utf-8")
    before = hashed(scenario)
    (scenario / "out.log").write_text("one more line\n", encoding="utf-8")
    assert hashed(scenario) == before


def test_file_that_a_planner_is_told_of_by_its_path_changes_the_hash(scenario, tmp_path_factory):
    file = tmp_path_factory.mktemp("elsewhere") / "line.csv"
    file.touch()
    launch = scenario / "my.launch"
    launch.write_text('<launch><arg name="waypoints"/></launch>', encoding="utf-8")
    driver = f"{{launch: my.launch, arguments: {{waypoints: {file}}}}}"
    text = (scenario / "own.yaml").read_text(encoding="utf-8")
    (scenario / "own.yaml").write_text(text.replace("pursuit, line: ./line.csv", driver), encoding="utf-8")
    before = hashed(scenario)
    file.write_text("0,0\n", encoding="utf-8")
    assert hashed(scenario) != before


def test_settings_and_software_change_the_hash(scenario):
    found = {hashed(scenario), hashed(scenario, "seed=2"), hashed(scenario, "seed=2", "laps=2")}
    assert len(found | {hashed(scenario, software="t")}) == 4


@pytest.fixture
def workspace(tmp_path, monkeypatch):
    """A workspace with one package and what was built of it."""
    for name in ("src/pkg/launch/a.launch", "src/pkg/README.md", "src/pkg/test/t.py", "devel/lib/pkg/node"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("one", encoding="utf-8")
    monkeypatch.setattr(
        inputs, "_workspace_folders", lambda: [str(tmp_path / "src/pkg"), str(tmp_path / "devel/lib")]
    )
    return tmp_path


@pytest.mark.parametrize("name", ["src/pkg/launch/a.launch", "devel/lib/pkg/node", "src/pkg/new.py"])
def test_sources_and_what_was_built_change_the_hash(workspace, name):
    before = hash_software()
    (workspace / name).write_text("two", encoding="utf-8")
    assert hash_software() != before


@pytest.mark.parametrize("name", ["src/pkg/README.md", "src/pkg/test/t.py", "src/pkg/.git/index"])
def test_what_no_run_depends_on_does_not(workspace, name):
    before = hash_software()
    (workspace / name).parent.mkdir(exist_ok=True)
    (workspace / name).write_text("two", encoding="utf-8")
    assert hash_software() == before


def test_a_renamed_file_changes_the_hash(workspace):
    before = hash_software()
    (workspace / "devel/lib/pkg/node").rename(workspace / "devel/lib/pkg/other")
    assert hash_software() != before


def test_the_workspaces_are_those_that_are_sourced(monkeypatch, tmp_path):
    monkeypatch.setenv("CMAKE_PREFIX_PATH", f"{tmp_path}:/usr")
    folders = inputs._workspace_folders()
    assert str(lookup.package_path("f1tenth_scenarios")) in folders
    assert not [each for each in folders if each.startswith(("/opt/ros/", "/usr/share/", "/usr/lib/"))]
    assert any(each.endswith("/lib") for each in folders)


def test_a_workspace_may_be_anywhere_but_among_the_packages_of_the_system(monkeypatch):
    system, own = ["/opt/ros/noetic", "/usr"], ["/opt/ws/devel", "/usr/src/ws/devel", "/usr/local"]
    monkeypatch.setenv("CMAKE_PREFIX_PATH", ":".join([*system, *own]))
    folders = inputs._workspace_folders()
    assert folders[-3:] == [f"{each}/lib" for each in own]
    assert not {f"{each}/lib" for each in system} & {*folders}


def test_libraries_of_the_system_are_not_hashed_where_nothing_is_sourced(monkeypatch):
    monkeypatch.delenv("CMAKE_PREFIX_PATH", raising=False)
    assert "/lib" not in inputs._workspace_folders()
