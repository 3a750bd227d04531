"""What a planner's launch file starts is looked for before anything starts."""

import pytest
from f1tenth_judge.errors import ScenarioError
from f1tenth_judge.places import packages
from f1tenth_judge.plan.launched_nodes import check_nodes


class Fixed:
    def __init__(self, folder):
        self._folder = folder

    def names(self):
        return ["my_stack"]

    def path(self, package):
        return self._folder if package == "my_stack" else None


@pytest.fixture
def launch(tmp_path, monkeypatch):
    """Checks a launch file with one element, beside a package with a program and a file that is none."""
    (tmp_path / "scripts").mkdir()
    for name, mode in (("planner", 0o755), ("forgotten.py", 0o644)):
        (tmp_path / "scripts" / name).touch(mode)
    monkeypatch.setattr(packages, "_known", Fixed(tmp_path))

    def check(element):
        file = tmp_path / "my.launch"
        file.write_text(f"<launch>{element}</launch>")
        check_nodes(file)

    return check


def node(package, program, more=""):
    return f'<node name="n" pkg="{package}" type="{program}" {more}/>'


@pytest.mark.parametrize(
    "element",
    [
        node("my_stack", "planner"),
        node("$(arg package)", "planner"),
        node("my_stack", "$(arg kind).py"),
        node("gone", "planner", 'if="$(arg gui)"'),
        f'<group unless="$(arg quiet)">{node("gone", "planner")}</group>',
    ],
)
def test_what_can_be_started_or_is_not_certain_is_left_alone(launch, element):
    launch(element)


@pytest.mark.parametrize(
    ("element", "problem"),
    [
        (node("my_stak", "planner"), "node 'n': there is no package 'my_stak'; is 'my_stack' meant?"),
        (node("other", "planner"), "there is no package 'other'; is its workspace sourced?"),
        (node("my_stack", "planer"), "package 'my_stack' has no program 'planer'; is it built?"),
        (
            f"<group>{node('my_stack', 'forgotten.py')}</group>",
            "is not executable; run: chmod",
        ),
    ],
)
def test_what_cannot_be_started_is_named_with_what_to_do(launch, element, problem):
    with pytest.raises(ScenarioError, match=problem):
        launch(element)
