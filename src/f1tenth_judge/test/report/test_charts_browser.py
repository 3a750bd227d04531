"""The charts of a run: a part of time or road is looked at closely, in all of them and in the map."""

import re

import pytest
from browser import PATIENCE, chromium
from f1tenth_judge.report.bundle import bundle
from f1tenth_judge.report.page import WEB, write_report
from report_samples import result, write_run

pytest.importorskip("selenium", reason="python3-selenium is not installed")

from selenium.webdriver.common.action_chains import ActionChains  # noqa: E402
from selenium.webdriver.common.actions.wheel_input import ScrollOrigin  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402
from selenium.webdriver.support.ui import Select, WebDriverWait  # noqa: E402

END, PLOT = 10.0, (44, 10)  # s; px beside the plot


@pytest.fixture(scope="module")
def address(tmp_path_factory):
    folder = tmp_path_factory.mktemp("charts")
    write_run(folder / "results" / "run", result("run"), end=END)
    write_report(folder / "results", folder / "report.html")
    return (folder / "report.html").as_uri()


@pytest.fixture
def page(window, address):
    window.get("about:blank")
    window.get(f"{address}#run")
    WebDriverWait(window, PATIENCE).until(lambda _: window.find_elements("css selector", ".chart"))
    yield window
    assert window.get_log("browser") == []


def find(page, selector):
    return page.find_element("css selector", selector)


def span(page):
    """What the charts show: from, to; None if that is all."""
    numbers = re.findall(r"[\d.]+", find(page, ".tools-of-charts output").text)
    return tuple(map(float, numbers)) or None


def on_chart(page, time):
    """A pointer on the first chart, at a time (s) of the whole run."""
    canvas = find(page, ".chart canvas")
    left, right = PLOT
    width = canvas.size["width"] - left - right
    return canvas, round(left + time / END * width - canvas.size["width"] / 2)


def click(page, time):
    canvas, x = on_chart(page, time)
    ActionChains(page).move_to_element_with_offset(canvas, x, 0).click().perform()


def drag(page):
    canvas, x = on_chart(page, 5.0)
    chain = ActionChains(page).move_to_element_with_offset(canvas, x, 0).click_and_hold()
    chain.move_by_offset(100, 0).release().perform()


def turn_wheel(page, time, pixels):
    canvas, x = on_chart(page, time)
    ActionChains(page).scroll_from_origin(ScrollOrigin(canvas, x, 0), 0, pixels).perform()


def pictures(page):
    """What the map and the charts look like."""
    return page.execute_script(
        "return [...document.querySelectorAll('canvas')].map((each) => each.toDataURL())"
    )


def now(page):
    return float(find(page, ".scrub").get_property("value"))


def test_wheel_zooms_the_chart_that_was_chosen_around_the_pointer(page):
    turn_wheel(page, 5.0, -200)
    assert span(page) is None  # the page is scrolled
    click(page, 5.0)
    turn_wheel(page, 8.0, -1000)  # by exp(1.5)
    begins, ends = span(page)
    assert ends - begins == pytest.approx(END / 4.48, abs=0.2)
    assert (8.0 - begins) / (ends - begins) == pytest.approx(0.8, abs=0.05)
    turn_wheel(page, 8.0, 2000)
    assert span(page) is None


def test_all_charts_and_the_map_show_the_same_part(page):
    click(page, 5.0)
    before = pictures(page)
    find(page, "[aria-label='zoom in']").click()
    assert span(page) == pytest.approx((2.5, 7.5), abs=0.1)
    assert all(one != other for one, other in zip(before, pictures(page)))
    find(page, ".tools-of-charts button:nth-of-type(3)").click()
    assert span(page) is None
    assert pictures(page)[1:] == before[1:]


def test_drag_seeks_in_the_whole_and_moves_a_part(page):
    drag(page)
    assert now(page) > 5.5
    click(page, 5.0)
    find(page, "[aria-label='zoom in']").click()
    begins, ends = span(page)
    drag(page)
    moved = span(page)
    assert moved[0] < begins - 0.3
    assert moved[1] - moved[0] == pytest.approx(ends - begins, abs=0.11)


def test_keys_zoom_move_and_show_all(page):
    body = find(page, "body")
    body.send_keys(Keys.HOME, *[Keys.ARROW_RIGHT] * 4, "+", "+")
    assert span(page) == pytest.approx((3.0, 5.5), abs=0.1)
    body.send_keys(".", ".", ",")
    assert span(page) == pytest.approx((3.6, 6.1), abs=0.15)
    body.send_keys("-")
    assert span(page)[1] - span(page)[0] == pytest.approx(5.0, abs=0.11)
    body.send_keys("0")
    assert span(page) is None


def test_part_goes_on_with_the_moment(page):
    find(page, "body").send_keys(Keys.HOME, "+", "+", "+")
    assert span(page) == pytest.approx((0.0, 1.3), abs=0.1)
    find(page, "body").send_keys(*[Keys.ARROW_RIGHT] * 6)
    begins, ends = span(page)
    assert begins <= 6.0 <= ends


def test_part_is_in_metres_along_the_road(page):
    Select(find(page, "[aria-label='charts over']")).select_by_value("way")
    find(page, "body").send_keys(Keys.END, "+")
    assert find(page, ".tools-of-charts output").text.endswith("\u202fm")
    begins, ends = span(page)
    assert ends - begins == pytest.approx(7.5, abs=0.3)  # half of 10 s at 1.5 m/s


def test_two_fingers_zoom(address):
    with chromium(390, 844, phone=True) as phone:
        phone.get(f"{address}#run")
        WebDriverWait(phone, PATIENCE).until(lambda _: phone.find_elements("css selector", ".chart"))
        spread = """
        const canvas = document.querySelector(".chart canvas");
        const { left, top } = canvas.getBoundingClientRect();
        canvas.setPointerCapture = () => {};
        const send = (type, pointerId, x) => canvas.dispatchEvent(
          new PointerEvent(type, { pointerId, clientX: left + x, clientY: top + 40, pointerType: "touch" }));
        send("pointerdown", 1, 150);
        send("pointerdown", 2, 200);
        send("pointermove", 2, 250);
        send("pointerup", 1, 150);
        send("pointerup", 2, 250);
        """
        phone.execute_script(spread)
        begins, ends = span(phone)
        assert ends - begins == pytest.approx(END / 2, abs=0.2)


RANGES = [
    ((-3, -1), (-4, 0, 1)),
    ((-0.4, 0.4), (-0.5, 0.5, 0.5)),
    ((0, 7.9), (0, 10, 5)),
    ((1e-7, 9e-7), (0, 1e-6, 5e-7)),
]


@pytest.mark.parametrize(("values", "expected"), RANGES)
def test_axis_has_room_for_all_values(window, values, expected):
    code = bundle(WEB / "charts" / "axis.js")
    low, high, step = window.execute_script(
        f"{code}const {{ low, high, step }} = niceRange(...arguments); return [low, high, step];", *values
    )
    assert (low, high, step) == pytest.approx(expected)


LABELS = [
    ((-0.5, 0.5), "−0.5"),
    ((-0.0, 0.5), "0.0"),
    ((12, 2), "12"),
    ((250000, 50000), "2.5e+5"),
    ((2e-6, 1e-6), "2.0e−6"),
]


@pytest.mark.parametrize(("place", "text"), LABELS)
def test_labels_are_as_fine_as_the_axis(window, place, text):
    code = bundle(WEB / "charts" / "axis.js")
    assert window.execute_script(f"{code}return axisLabel(...arguments);", *place) == text
