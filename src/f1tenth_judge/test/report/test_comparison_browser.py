"""Two runs over one another: time lost, corners, charts along the road."""

import math

import pytest
from browser import PATIENCE
from f1tenth_judge.report.bundle import bundle
from f1tenth_judge.report.page import WEB, write_report
from report_samples import driven_by, result, write_run

pytest.importorskip("selenium", reason="python3-selenium is not installed")

from selenium.webdriver.common.keys import Keys  # noqa: E402
from selenium.webdriver.support.ui import Select, WebDriverWait  # noqa: E402

FAST, SLOW = 1.5, 1.0  # m/s


@pytest.fixture(scope="module")
def report(tmp_path_factory):
    folder = tmp_path_factory.mktemp("comparison")
    for name, speed in (("fast", FAST), ("slow", SLOW)):
        cars = {"robot1": {**driven_by(f"/robots/{name}.py:Planner", "Python class"), "lap_times": []}}
        write_run(folder / "results" / name, result(name, cars=cars), speed=speed, end=20.0)
    write_report(folder / "results", folder / "report.html")
    return (folder / "report.html").as_uri()


@pytest.fixture
def compared(window, report):
    """The page of the fast run, beside the slow one."""
    window.get("about:blank")
    window.get(f"{report}#fast")
    WebDriverWait(window, PATIENCE).until(lambda _: window.find_elements("css selector", ".map"))
    choice = Select(window.find_element("css selector", "[aria-label=reference]"))
    assert [each.text for each in choice.options] == [
        "no reference", "slow · slow.py:Planner · 9.500\u202fs",
    ]  # fmt: skip
    choice.select_by_index(1)
    WebDriverWait(window, PATIENCE).until(lambda _: chart(window, "Time lost on the reference (s)"))
    yield window
    assert window.get_log("browser") == []


def chart(window, title):
    found = window.find_elements("xpath", f"//figure[.//span[.='{title}']]")
    return found[0] if found else None


def value(window, title):
    return float(chart(window, title).find_element("css selector", ".value").text.replace("−", "-"))


def test_time_is_lost_and_gained_along_the_road(compared):
    body = compared.find_element("css selector", "body")
    body.send_keys(Keys.HOME, *[Keys.ARROW_RIGHT] * 6)
    assert value(compared, "Time lost on the reference (s)") == pytest.approx(6 - 6 * FAST / SLOW, abs=0.15)
    assert "gains time" in compared.find_element("css selector", ".legend:not([hidden])").text


def test_without_a_reference_nothing_is_compared(compared):
    Select(compared.find_element("css selector", "[aria-label=reference]")).select_by_index(0)
    assert chart(compared, "Time lost on the reference (s)") is None
    assert not compared.find_element("css selector", "[data-part=ghost]").is_displayed()


def test_charts_are_over_time_or_over_distance(compared):
    Select(compared.find_element("css selector", "[aria-label='charts over']")).select_by_value("way")
    canvas = chart(compared, "Speed (m/s)").find_element("css selector", "canvas")
    canvas.click()  # in its middle: half of the way of the faster run
    time = float(compared.find_element("css selector", ".scrub").get_property("value"))
    assert time == pytest.approx(10.0, abs=0.5)


def test_corners_have_speeds_beside_those_of_the_reference(compared):
    (row,) = compared.find_elements("xpath", "//section[h2='Corners']//tbody/tr")
    assert row.text.split() == ["T1", *["1.50", "m/s", "+0.50"] * 3]


STADIUM = """
const [length, radius, step] = [10, 2, 0.1];
const road = { x: [], y: [] };
const put = (x, y) => { road.x.push(x); road.y.push(y); };
for (let s = 0; s < length; s += step) put(s, -radius);
for (let a = 0; a < Math.PI; a += step / radius) put(length + radius * Math.sin(a), -radius * Math.cos(a));
for (let s = length; s > 0; s -= step) put(s, radius);
for (let a = 0; a < Math.PI; a += step / radius) put(-radius * Math.sin(a), radius * Math.cos(a));
const found = cornersOf(road);
return [lengthOf(road), found.map(({ number, from, to, x }) => [number, from, to, x])];
"""


def test_corners_are_where_the_road_bends(window):
    code = bundle(WEB / "compare" / "corners.js")
    length, corners = window.execute_script(f"{code}{STADIUM}")
    bend = 2 * math.pi  # m, of a half circle
    assert length == pytest.approx(20 + 2 * bend, abs=0.2)
    (first, begin, end, x), (second, *_) = corners
    assert (first, second) == (1, 2)
    assert (begin, end) == (pytest.approx(10.0, abs=1.5), pytest.approx(10 + bend, abs=1.5))
    assert x == pytest.approx(12.0, abs=0.3)


PLACES = [
    (9.0, "before T1"),
    (12.0, "in T1"),
    (19.0, "after T1"),
    (23.0, "before T2"),
    (31.0, "after T2"),
    (52.0, "in T1"),
]


@pytest.mark.parametrize(("way", "words"), PLACES)
def test_place_is_told_by_the_nearest_corner(window, way, words):
    corners = [{"number": 1, "from": 10.0, "to": 16.0}, {"number": 2, "from": 24.0, "to": 30.0}]
    code = bundle(WEB / "compare" / "corners.js")
    assert window.execute_script(f"{code}return whereOf(...arguments);", corners, 40.0, way) == words
