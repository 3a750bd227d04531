"""What the page of a failed run says first: what happened, where, when, and what led to it."""

import math

import pytest
from browser import PATIENCE
from f1tenth_judge.report.bundle import bundle
from f1tenth_judge.report.page import WEB, write_report
from report_samples import RADIUS, contact, result, write_run

pytest.importorskip("selenium", reason="python3-selenium is not installed")

from selenium.webdriver.support.ui import WebDriverWait  # noqa: E402

END = 10.0  # s


@pytest.fixture(scope="module")
def address(tmp_path_factory):
    folder = tmp_path_factory.mktemp("failed")
    touch = {**contact(), "start": 6.0, "end": 6.1}
    times = {"start": 0.0, "finish": 6.0, "lap_time": None, "wall": 1.0}
    write_run(folder / "results" / "hit", result("hit", False, contacts=[touch], times=times), end=END)
    culprit = {
        "culprit": "robot1/planner",
        "reason": "ended",
        "log_file": None,
        "log_lines": [],
        "stamp": 3.5,
    }
    died = result(
        "died", False, verdict="error", contacts=[], culprit=culprit, reason="robot1/planner: ended"
    )
    write_run(folder / "results" / "died", died, end=END)
    late = result("late", False, verdict="timeout", contacts=[], reason="not finished after 10 s")
    write_run(folder / "results" / "late", late, end=END, speed=0.0)
    backwards = result("backwards", False, contacts=[touch], times=times)
    write_run(folder / "results" / "backwards", backwards, end=END, speed=-1.5)
    write_run(folder / "results" / "passed", result("passed"), end=END)
    write_report(folder / "results", folder / "report.html")
    return (folder / "report.html").as_uri()


def opened(window, address, name):
    window.get("about:blank")
    window.get(f"{address}#{name}")
    WebDriverWait(window, PATIENCE).until(lambda _: window.find_elements("css selector", ".chart"))
    assert window.get_log("browser") == []
    return float(window.find_element("css selector", ".scrub").get_property("value"))


def reason(window):
    return window.find_element("css selector", ".reason").text


def rows_of(window):
    (card,) = window.find_elements("css selector", ".last-second")
    return [
        [cell.text for cell in row.find_elements("css selector", "th, td")]
        for row in card.find_elements("css selector", "tr")
    ]


def test_collision_opens_a_second_before_and_says_what_led_to_it(window, address):
    assert opened(window, address, "hit") == 5.0
    assert reason(window).endswith(" at 1.000 s, in T1")
    heads, *rows = rows_of(window)
    assert heads == ["", "−1.0\u202fs", "−0.5\u202fs", "−0.2\u202fs", "6.000\u202fs"]
    values = {name: cells for name, *cells in rows}
    assert values["speed (m/s)"] == ["1.50"] * 4
    assert values["steering (rad, left +)"] == ["0.10"] * 4
    assert float(values["left of the middle (m)"][0].replace("−", "-")) == pytest.approx(0.0, abs=0.05)
    assert values["error"][1:] == ["−0.50"] * 3


def test_planner_that_ended_has_a_time_and_a_place(window, address):
    assert opened(window, address, "died") == 2.5
    assert reason(window).endswith("robot1/planner: ended, at 3.500\u202fs, in T1")


def test_car_that_stood_is_told(window, address):
    assert opened(window, address, "late") == 9.0
    assert reason(window).endswith("not finished after 10 s, in T1, standing still since 0.0\u202fs")


def test_car_that_drove_the_wrong_way_is_told(window, address):
    opened(window, address, "backwards")
    assert reason(window).endswith("driving against the direction of the road")


def test_passed_run_opens_at_its_beginning(window, address):
    assert opened(window, address, "passed") == 0.0
    assert window.find_elements("css selector", ".last-second") == []


@pytest.mark.parametrize(("radius", "turn", "offset", "angle"), [(2.5, 0.0, 0.5, 0.0), (3.5, 0.4, -0.5, 0.4)])
def test_offset_and_angle_are_positive_to_the_left(window, radius, turn, offset, angle):
    circle = [2 * math.pi * index / 200 for index in range(200)]
    road = {
        "x": [RADIUS * math.cos(each) for each in circle],
        "y": [RADIUS * math.sin(each) for each in circle],
    }
    pose = {"x": radius, "y": 0.0, "yaw": math.pi / 2 + turn + 2 * math.pi}
    code = bundle(WEB / "compare" / "beside.js")
    found = window.execute_script(f"{code}return besideRoad(...arguments);", road, pose)
    assert (found["offset"], found["angle"]) == pytest.approx((offset, angle), abs=0.03)
