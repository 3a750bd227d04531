"""The report in a browser: it draws, plays, answers keys and fits a phone."""

import math

import pytest
from browser import PATIENCE, chromium
from f1tenth_judge.report.bundle import bundle
from f1tenth_judge.report.page import WEB, write_report
from report_samples import RADIUS, contact, failed_criteria, race_result, result, write_race, write_run

pytest.importorskip("selenium", reason="python3-selenium is not installed")

from selenium.common.exceptions import StaleElementReferenceException  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402
from selenium.webdriver.support.ui import Select, WebDriverWait  # noqa: E402

SPEED = 1.5  # m/s


@pytest.fixture(scope="module")
def report(tmp_path_factory):
    folder = tmp_path_factory.mktemp("report")
    write_run(folder / "results" / "one_lap", result("one_lap"), speed=SPEED)
    write_run(folder / "results" / "two", hit("two"), speed=SPEED)
    before = result(
        "two", commit="old", versions={"commit": "old", "driver_commits": {"robot1": "mine-dirty"}}
    )
    write_run(folder / "results" / "two" / "previous", before, speed=1.0)
    write_race(folder / "results" / "zwei", race_result("zwei", minimum_clearance=0.1))
    (folder / "results" / "one_lap" / "log").mkdir()
    write_report(folder / "results", folder / "report.html")
    return (folder / "report.html").as_uri()


def hit(name):
    cheat = {"time": 5.0, "kind": "set_model_state", "caller": "cheat", "model": "robot1"}
    touch = {**contact(), "start": 2.0, "end": 2.1}
    return result(name, passed=False, minimum_clearance=0.3, contacts=[touch], interventions=[cheat])


@pytest.fixture(autouse=True)
def _no_complaints(window):
    yield
    assert window.get_log("browser") == []


def open_run(window, report, name):
    window.get("about:blank")
    window.get(f"{report}#{name}")
    until(window, lambda: window.find_elements("css selector", ".map"))


def until(window, condition):
    """Waits for the condition, also past elements that the page replaces while they are looked at."""
    wait = WebDriverWait(window, PATIENCE, ignored_exceptions=(StaleElementReferenceException,))
    return wait.until(lambda _: condition())


def find(window, selector):
    return window.find_element("css selector", selector)


def press(window, *keys):
    find(window, "body").send_keys(*keys)


def pose(window):
    return tuple(float(each) for each in find(window, ".stage").get_attribute("data-pose").split())


def time(window):
    return float(find(window, ".scrub").get_property("value"))


def test_overview_lists_the_runs(window, report):
    window.get(report)
    assert find(window, "h1").text == "1 of 3 scenarios did not end as expected"
    rows = [row.text for row in window.find_elements("css selector", "tbody tr")]
    assert "one_lap" in rows[0]
    assert "collision, expected success" in rows[1]
    assert "broken" in rows[1]


def shown_rows(window):
    return [row.is_displayed() for row in window.find_elements("css selector", "tbody tr")]


def test_overview_is_filtered_by_text(window, report):
    window.get(report)
    find(window, ".search").send_keys("touched")
    assert shown_rows(window) == [False, True, False]
    find(window, ".search").send_keys(" nothing")
    assert shown_rows(window) == [False, False, False]
    assert "No run matches." in find(window, "main").text


def test_overview_is_filtered_by_verdict(window, report):
    window.get(report)
    choice = Select(find(window, ".tools select"))
    assert [option.text for option in choice.options] == [
        "all runs (3)", "not as expected (1)", "collision (1)", "success (2)",
    ]  # fmt: skip
    for text, rows in (
        ("success (2)", [True, False, True]),
        ("not as expected (1)", [False, True, False]),
        ("all runs (3)", [True, True, True]),
    ):
        choice.select_by_visible_text(text)
        assert shown_rows(window) == rows


def names_in_order(window):
    return [name.text for name in window.find_elements("css selector", "tbody .name a")]


def test_overview_is_put_in_order_by_any_column(window, report):
    window.get(report)
    head = window.find_element("xpath", "//th[button='clearance']")
    head.find_element("css selector", "button").click()
    assert head.get_attribute("aria-sort") == "ascending"
    assert names_in_order(window) == ["zwei", "one_lap", "two"]
    head.find_element("css selector", "button").click()
    assert names_in_order(window) == ["two", "one_lap", "zwei"]
    window.find_element("xpath", "//th/button[.='run']").click()
    assert names_in_order(window) == ["one_lap", "two", "zwei"]


def test_a_run_is_opened_from_where_the_order_has_put_it(window, report):
    window.get(report)
    window.find_element("xpath", "//th/button[.='clearance']").click()
    find(window, "tbody tr").click()
    until(window, lambda: window.find_elements("css selector", ".map"))
    assert find(window, "h1").text.startswith("zwei")


def test_everybody_is_told_who_drives_and_who_won(window, report):
    window.get(report)
    row = window.find_elements("css selector", "tbody tr")[2].text
    assert "robot1 gap.py:Gap" in row
    assert "robot2 race" in row
    open_run(window, report, "zwei")
    assert (
        find(window, "header .reason:last-of-type").text
        == "robot1 (gap.py:Gap) won; second was robot2 (race), 1.250\u202fs later"
    )


def test_every_criterion_that_failed_is_told(window, tmp_path):
    write_run(tmp_path / "results" / "criteria", failed_criteria("criteria"))
    write_report(tmp_path / "results", tmp_path / "report.html")
    open_run(window, (tmp_path / "report.html").as_uri(), "criteria")
    told = [each.text for each in window.find_elements("css selector", "header .reason")]
    assert told == [
        "success, but 2 criteria failed",
        "minimum_clearance — came as close as 0.076 m (0.076\u202fm, limit 0.100\u202fm)",
        "lap_time — lap 1 of robot1 took 9.500 s (9.500\u202fs, limit 9\u202fs)",
    ]
    first, second = (row.text for row in window.find_elements("css selector", ".criteria tbody tr.failed"))
    assert "minimum_clearance" in first
    assert "lap_time" in second


def test_names_can_be_copied_into_a_command(window, report):
    open_run(window, report, "one_lap")
    assert find(window, "h1").text.startswith("one_lap")
    codes = [each.text for each in window.find_elements("css selector", ".facts code")]
    assert "minimum_clearance" in codes


def test_row_opens_its_run(window, report):
    window.get(report)
    find(window, "tbody tr").click()
    until(window, lambda: window.find_elements("css selector", ".map"))
    assert find(window, "h1").text.startswith("one_lap")


def test_play_moves_the_car_and_ends_with_the_run(window, report):
    open_run(window, report, "one_lap")
    start = pose(window)
    find(window, ".play").click()
    until(window, lambda: math.dist(pose(window), start) > 0.5)
    assert find(window, ".play").get_attribute("aria-label") == "pause"
    press(window, Keys.END)
    until(window, lambda: find(window, ".play").get_attribute("aria-label") == "play")
    assert time(window) == pytest.approx(10.0)


def test_car_is_where_the_record_has_it(window, report):
    open_run(window, report, "one_lap")
    for _ in range(4):
        press(window, Keys.ARROW_RIGHT)
    turn = SPEED * 4.0 / RADIUS
    assert time(window) == pytest.approx(4.0)
    assert pose(window) == pytest.approx((RADIUS * math.cos(turn), RADIUS * math.sin(turn)), abs=0.01)


def test_keys_do_what_they_say(window, report):
    open_run(window, report, "one_lap")
    press(window, " ")
    until(window, lambda: time(window) > 0.2)
    press(window, " ", Keys.HOME)
    assert time(window) == 0.0
    press(window, Keys.END, Keys.ARROW_LEFT)
    assert time(window) == pytest.approx(9.0)
    press(window, Keys.ARROW_UP)
    assert find(window, "select").get_property("value") == "2"
    press(window, "s")
    assert find(window, "[data-part=scan]").get_attribute("aria-pressed") == "false"
    press(window, "j")
    until(window, lambda: find(window, "h1").text.startswith("two"))
    press(window, Keys.ESCAPE)
    until(window, lambda: window.find_elements("css selector", ".overview"))


def test_scrubbing_moves_the_car_and_the_charts(window, report):
    open_run(window, report, "one_lap")
    find(window, ".chart canvas").click()
    assert 3.0 < time(window) < 7.0
    before = find(window, ".chart:nth-of-type(4) .value").text
    press(window, Keys.HOME)
    assert find(window, ".chart:nth-of-type(4) .value").text != before


def test_runs_that_are_compared_are_named_by_the_commits_of_workspace_and_driver(window, report):
    open_run(window, report, "two")
    assert "driver_commits of robot1" in find(window, "body").text
    assert "[object Object]" not in find(window, "body").text
    assert "before old + mine-dir* now 01234567" in " ".join(find(window, "body").text.split())


def test_pixels_change_when_the_car_moves(window, report):
    open_run(window, report, "one_lap")
    picture = "return document.querySelector('.map').toDataURL()"
    before = window.execute_script(picture)
    press(window, Keys.ARROW_RIGHT)
    assert window.execute_script(picture) != before


SEEN = """
const lidar = new Lidar(null, [-Math.PI / 2, Math.PI / 2, 0, 0, 0, 5]);
const wall = obstaclesOf({ outlines: [{ x: [2, 2, 2.1, 2.1], y: [-1, 1, 1, -1] }], circles: [] });
const circle = { outlines: [], circles: [{ x: 0.2, y: 0, radius: 0.2 }] };
const post = obstaclesOf(circle, { x: 0, y: 1, yaw: Math.PI / 2 });
const seen = lidar.points({ x: 0, y: 0, yaw: 0 }, {
  segments: [...wall.segments, ...post.segments], circles: [...wall.circles, ...post.circles],
});
const { points } = seen;
return [points[0], points[60], points[120]].map(({ x, y, hit }) => [x, y, hit]);
"""


def test_lidar_meets_walls_models_and_cars(window, report):
    open_run(window, report, "zwei")
    # Seen from the origin, with a wall 2 m ahead, a post 1 m to the left and nothing behind.
    hits = window.execute_script(f"{bundle(WEB / 'data' / 'run.js')}{SEEN}")
    assert hits[0] == [pytest.approx(0.0, abs=1e-9), pytest.approx(-5.0), False]
    assert hits[1] == [pytest.approx(2.0), pytest.approx(0.0, abs=1e-9), True]
    assert hits[2] == [pytest.approx(0.0, abs=1e-9), pytest.approx(1.0), True]


SIZES = """
const truck = [-0.13, 0.57, -0.18, 0.18, 0.42, 0.26];
return [truck, undefined].map((body) => new CarTrack("robot1", {}, body).shape.outlines[0].x.slice(0, 2));
"""


def test_car_is_as_large_as_its_description_says_else_as_the_f1tenth_car(window, report):
    open_run(window, report, "one_lap")
    code = bundle(WEB / "data" / "run.js")
    assert window.execute_script(f"{code}{SIZES}") == [[-0.13, 0.57], [-0.1186, 0.4615]]


def test_race_of_two_shows_the_gap(window, report):
    open_run(window, report, "zwei")
    press(window, Keys.END)
    chart = window.find_elements("css selector", ".chart")[4]
    assert chart.find_element("css selector", "figcaption").text.startswith("Gap to the leader (m)")
    first, second = chart.find_element("css selector", ".value").text.split()
    assert (float(first), float(second)) == (pytest.approx(0.0), pytest.approx(5.0, abs=0.3))
    open_run(window, report, "one_lap")
    titles = window.find_elements("css selector", ".chart figcaption span:first-child")
    assert [each.text for each in titles] == [
        "Speed (m/s)",
        "Steering (rad)",
        "Acceleration (m/s²)",
        "Clearance (m)",
        "/robot1/error",
    ]


def test_files_are_linked(window, report):
    open_run(window, report, "one_lap")
    links = {
        each.text: each.get_attribute("href") for each in window.find_elements("css selector", ".facts td a")
    }
    assert links["results/one_lap/log"].endswith("/results/one_lap/log")


def test_run_before_is_compared(window, report):
    open_run(window, report, "two")
    assert "The trajectories differ." in find(window, ".facts").text
    assert find(window, "[data-part=ghost]").get_attribute("aria-pressed") == "true"


def test_contact_leads_to_the_second_before_it(window, report):
    open_run(window, report, "two")
    for selector in ("button.link", ".mark-at.contact"):
        press(window, Keys.END)
        find(window, selector).click()
        assert time(window) == pytest.approx(1.0)
    assert find(window, ".mark-at.contact").get_attribute("title") == "robot1 touched Wall_1 at 2.000\u202fs"
    assert (
        find(window, ".mark-at.intervention")
        .get_attribute("title")
        .startswith("cheat called set_model_state")
    )


def test_the_address_of_a_moment_opens_it(window, report):
    open_run(window, report, "two?t=3.5")
    assert time(window) == pytest.approx(3.5)
    press(window, Keys.ARROW_RIGHT)
    window.find_element("xpath", "//button[.='link']").click()
    assert window.current_url.endswith("#two?t=4.500")
    open_run(window, report, "one_lap?t=wrong")
    assert time(window) == 0.0


def test_the_last_second_before_a_contact_is_slow(window, report):
    code = bundle(WEB / "replay" / "player.js")
    paces = """
    const player = new Player(10, [{ from: 1, to: 2 }], () => {});
    const paces = [0.5, 1, 1.9, 2].map((time) => { player.time = time; return player.pace; });
    player.inSlowMotion = false;
    player.time = 1.5;
    return [...paces, player.pace];
    """
    assert window.execute_script(f"{code}{paces}") == [1, 0.25, 0.25, 1, 1]
    open_run(window, report, "two")
    button = window.find_element("xpath", "//button[.='slow motion']")
    button.click()
    assert button.get_attribute("aria-pressed") == "false"


def test_a_reason_of_long_names_stays_in_its_card(window, tmp_path):
    content = result("long")
    content["criteria"][0]["reason"] = f"{'planner_package/' * 4}follow_the_gap: cannot be started"
    write_run(tmp_path / "results" / "long", content)
    write_report(tmp_path / "results", tmp_path / "report.html")
    open_run(window, (tmp_path / "report.html").as_uri(), "long")
    page, view = window.execute_script("return [document.body.scrollWidth, document.body.clientWidth]")
    assert page <= view


def test_phone_shows_every_column_without_scrolling_sideways(report, window):
    with chromium(390, 844, phone=True) as phone:
        for page in ("", "#two"):
            phone.get("about:blank")
            phone.get(f"{report}{page}")
            until(phone, lambda: phone.find_elements("css selector", ".map, .overview"))
            assert phone.execute_script("return document.documentElement.scrollWidth") <= 390
            labels = phone.find_elements("css selector", "td[data-label]")
            assert all(each.size["width"] <= 390 for each in labels)
        assert phone.get_log("browser") == []


def test_what_the_planner_drew_published_and_saw_is_shown(window, report):
    open_run(window, report, "one_lap?t=1")
    assert find(window, "[data-part=drawings]").get_attribute("title") == "/robot1/candidates"
    assert "/robot1/error" in [each.text for each in window.find_elements("css selector", ".chart span")]
    picture = find(window, ".cameras img")
    assert picture.get_attribute("alt") == "seen on /robot1/camera/image_raw"
    first = picture.get_attribute("src")
    assert first.startswith("data:image/jpeg;base64,")
    press(window, Keys.END)
    assert until(window, lambda: picture.get_attribute("src") != first)
    press(window, Keys.HOME)
    drawn = map_of(window)
    press(window, "m")
    assert find(window, "[data-part=drawings]").get_attribute("aria-pressed") == "false"
    assert map_of(window) != drawn


def map_of(window):
    return window.execute_script("return document.querySelector('.map').toDataURL()")


def test_contacts_are_told_with_the_corner(window, report):
    open_run(window, report, "two")
    (row,) = window.find_elements("xpath", "//section[h2='Contacts']//tbody/tr")
    assert row.text.split()[-4:] == ["in", "T1", "1.50", "m/s"]
    assert find(window, ".reason").text.endswith("in T1")
