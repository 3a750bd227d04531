"""Every page of a results folder with every kind of run is in order, in every size and scheme."""

from pathlib import Path

import gymnasium
import numpy as np
import pytest
from browser import PATIENCE, chromium
from f1tenth_judge.drivers.starting import start_drivers
from f1tenth_judge.plan.race import Race, plan_race
from f1tenth_judge.report.page import write_report
from f1tenth_judge.run.execute import execute
from f1tenth_judge.scenario.driver import Driver
from f1tenth_judge.stop_request import StopRequest
from f1tenth_sim2d.environments import ENVIRONMENT, register
from report_samples import contact, driven_by, failed_criteria, race_result, result, write_race, write_run

pytest.importorskip("selenium", reason="python3-selenium is not installed")

from selenium.webdriver.support.ui import WebDriverWait  # noqa: E402

import f1tenth_sim2d  # noqa: E402

FAULTS = Path(__file__).with_name("page_faults.js").read_text(encoding="utf-8")
CLASSES = Path(__file__).parents[1] / "drivers" / "python" / "classes.py"
SCRIPT = "<img src=x onerror='window.hacked=1'><script>window.hacked=1</script>"
SIZES = [(1280, 900, "light"), (1000, 700, "dark"), (390, 844, "light"), (390, 844, "dark")]


@pytest.fixture(scope="module")
def report(tmp_path_factory):
    folder = tmp_path_factory.mktemp("every") / "results"
    made_up(folder)
    driven(folder)
    episodes(folder)
    write_report(folder, folder / "report.html")
    return folder


def made_up(folder):
    """What no planner of ours does at will."""
    write_run(folder / "passed", result("passed"))
    write_run(folder / "passed" / "previous", result("passed", commit="old"), speed=1.0)
    write_run(folder / "criteria", failed_criteria("criteria"))
    write_race(folder / "two", race_result("two"))
    write_run(folder / "foreign", foreign())
    write_run(folder / "nothing", result("nothing", passed=False), end=0.0)
    (folder / "broken").mkdir()
    (folder / "broken" / "result.json").write_text("{", encoding="utf-8")
    (folder / "broken" / "replay.json.gz").write_bytes(b"none")


def foreign():
    """A planner of ROS 2 that died and left words that are no text."""
    culprit = {
        "culprit": f"robot1/{SCRIPT}",
        "reason": "ended with exit code 1",
        "log_file": "log/robot1.log",
        "log_lines": [SCRIPT, "a_long_word_" * 30],
        "stamp": 1.0,
    }
    command = f"ros2 launch {'a_package/' * 12}planner.launch.py {SCRIPT}"
    cars = {"robot1": {**driven_by(command, "command of ROS 2"), "lap_times": [], "finish": None}}
    said = {"description": SCRIPT, "reason": f"robot1: {SCRIPT}", "not_written": [f"run.bag: {SCRIPT}"]}
    moved = [{"time": 2.0, "kind": "set_model_state", "caller": SCRIPT, "model": SCRIPT}]
    touch = {**contact(), "touched": [SCRIPT]}
    events = {"contacts": [touch], "interventions": moved}
    return result("foreign", passed=False, verdict="error", culprit=culprit, cars=cars, **said, **events)


def driven(folder):
    """A class drives into a wall, another one stops in time."""
    for name, planner, timeout in (("late", "Follower", 3), ("raises", "Raises", 5)):
        wanted = Race("circuit1", 1, [Driver(python=f"{CLASSES}:{planner}")])
        plan = plan_race(wanted, folder / name, [f"limits.timeout={timeout}"])
        execute(plan, start_drivers, StopRequest())


def episodes(folder):
    register()
    environment = gymnasium.make(ENVIRONMENT, place="circuit1", beams=20, record=folder / "e", max_time=1.0)
    environment.reset(seed=1)
    environment.step(np.zeros(2, dtype=np.float32))
    environment.close()
    many = f1tenth_sim2d.parallel_env(place="circuit1", record=folder / "f", max_time=0.5)
    many.reset(seed=1)
    while many.agents:
        many.step({agent: np.array([0.0, 0.5]) for agent in many.agents})
    many.close()
    for each in ("e", "f"):
        file = folder / each / "episode_0001" / "result.json"
        file.write_text(file.read_text().replace('"episode_0001"', f'"episode_{each}"'))
        file.parent.rename(folder / f"episode_{each}")
        (folder / each / "report.html").unlink()
        (folder / each).rmdir()


@pytest.mark.parametrize(("width", "height", "scheme"), SIZES)
def test_every_page_is_in_order(report, width, height, scheme):
    names = sorted(each.name for each in report.iterdir() if each.is_dir())
    assert len(names) == 10
    faults = {}
    with chromium(width, height, phone=width < 500) as window:
        feature = {"name": "prefers-color-scheme", "value": scheme}
        window.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": [feature]})
        for name in ["", *names]:
            open_page(window, f"{(report / 'report.html').as_uri()}#{name}")
            faults[name] = [*window.execute_script(FAULTS), *window.get_log("browser")]
    assert {name: found for name, found in faults.items() if found} == {}, names


def open_page(window, address):
    """Open it anew, and wait for its replay, if it has one."""
    window.get("about:blank")
    window.get(address)
    shown = "return document.querySelector('.overview, .run') && !document.querySelector('[aria-busy]')"
    WebDriverWait(window, PATIENCE).until(lambda _: window.execute_script(shown))
