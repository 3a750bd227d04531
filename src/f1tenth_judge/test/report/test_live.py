"""A run is watched while it goes on, and knows nothing of that."""

import json
import os
import socket
import threading
import urllib.parse
import urllib.request
from pathlib import Path

import pytest
from browser import PATIENCE, chromium
from f1tenth_judge.drivers.starting import start_drivers
from f1tenth_judge.plan.race import Race, plan_race
from f1tenth_judge.record.record import read_record
from f1tenth_judge.report.live.feed import Feed, Place
from f1tenth_judge.report.live.watching import watched
from f1tenth_judge.report.page import write_report
from f1tenth_judge.run.execute import execute
from f1tenth_judge.scenario.driver import Driver
from f1tenth_judge.stop_request import StopRequest
from scenario_samples import rows, write_record

CLASSES = Path(__file__).parents[1] / "drivers" / "python" / "classes.py"


def race_plan(folder):
    planner = Driver(python=f"{CLASSES}:Follower")
    return plan_race(
        Race("circuit1", 1, [planner], called="watched"), folder / "watched", ["limits.timeout=6"]
    )


def drive(plan):
    execute(plan, start_drivers, StopRequest())
    return json.loads((plan.folder / "result.json").read_text(encoding="utf-8"))["trajectory_hash"]


def messages(address):
    """What a watcher is told, until it is told the end."""
    told = []
    with urllib.request.urlopen(f"{address}events", timeout=PATIENCE) as stream:
        for line in stream:
            name, _, value = line.decode().strip().partition(": ")
            if name == "event":
                told.append((value, None))
            elif name == "data":
                told[-1] = (told[-1][0], json.loads(value))
            if told and told[-1][0] == "end" and told[-1][1] is not None:
                return told
    raise AssertionError("the stream ended without an end")


def connect(address):
    """A watcher who asks and then reads nothing, as one whose laptop sleeps."""
    place = urllib.parse.urlsplit(address)
    link = socket.create_connection((place.hostname, place.port))
    link.sendall(f"GET /events HTTP/1.1\r\nHost: {place.netloc}\r\n\r\n".encode())
    return link


def test_watchers_come_sleep_and_leave_and_the_run_is_the_same(tmp_path, capsys):
    alone = drive(race_plan(tmp_path / "alone"))
    plan, told = race_plan(tmp_path / "seen"), []
    with watched(plan) as lead_to:
        address = capsys.readouterr().out.split()[-1]
        watcher = threading.Thread(target=lambda: told.extend(messages(address)))
        watcher.start()
        with connect(address):
            connect(address).close()
            assert drive(plan) == alone
            lead_to("/report.html#watched")
            watcher.join(PATIENCE)
    news = [content for kind, content in told if kind == "news"]
    assert told[0][0] == "scene"
    assert [each["begins"] for each in news] == [True] + [False] * (len(news) - 1)
    times = [row[0] for each in news for row in each["cars"]["robot1"]]
    track = read_record(plan.record_file).tracks["robot1"]
    assert times == sorted(times)
    assert (times[0], times[-1]) == (pytest.approx(track.time[0]), pytest.approx(track.time[-1], abs=0.05))
    assert told[-1] == ("end", {"page": "/report.html#watched"})


def test_a_page_from_elsewhere_is_refused(tmp_path, capsys):
    with watched(race_plan(tmp_path)):
        address = capsys.readouterr().out.split()[-1]
        request = urllib.request.Request(address, headers={"Host": "elsewhere.example"})
        with pytest.raises(urllib.error.HTTPError, match="403"):
            urllib.request.urlopen(request, timeout=PATIENCE)


def test_the_page_follows_the_run_and_becomes_the_report(tmp_path, capsys):
    plan = race_plan(tmp_path)
    with chromium() as window, watched(plan) as lead_to:
        window.get(capsys.readouterr().out.split()[-1])
        until(window, "return document.querySelector('.note').textContent === 'Reading the recording…'")
        drive(plan)
        until(window, "return document.querySelector('.scrub')?.max > 1")
        assert window.title == "watched – live"
        write_report(plan.folder.parent, plan.folder.parent / "report.html")
        lead_to("/report.html#watched")
        until(window, "return document.querySelector('.criteria') && document.querySelector('.map')")
        assert window.current_url.endswith("/report.html#watched")
        assert window.get_log("browser") == []


def until(window, script):
    from selenium.webdriver.support.ui import WebDriverWait

    WebDriverWait(window, PATIENCE).until(lambda _: window.execute_script(script))


@pytest.fixture
def feed(tmp_path):
    return Feed(tmp_path / "record.csv", tmp_path / "interventions.jsonl")


def test_a_late_watcher_is_told_all_in_fewer_rows(feed, tmp_path):
    write_record(tmp_path / "record.csv", rows(200.0))
    feed.poll()
    told = feed.news(Place(), 0.0)["cars"]["robot1"]
    assert 500 < len(told) <= 1000
    assert (told[0][0], told[-1][0]) == (0.025, pytest.approx(200.0, abs=0.5))


def test_a_watcher_is_told_everything_once(feed, tmp_path):
    place = Place()
    write_record(tmp_path / "record.csv", rows(1.0))
    feed.poll()
    first = feed.news(place, 0.0)["cars"]["robot1"]
    assert feed.news(place, 0.0) is None
    with open(tmp_path / "record.csv", "a", encoding="utf-8") as stream:
        for row in list(rows(2.0))[40:]:
            stream.write(",".join(map(str, row)) + "\n")
    feed.poll()
    second = feed.news(place, 0.0)
    assert not second["begins"]
    assert len(first) + len(second["cars"]["robot1"]) == 40


def test_contacts_and_interventions_are_events(feed, tmp_path):
    write_record(tmp_path / "record.csv", rows(1.0, contacts={0.5: "Wall_1", 0.525: "Wall_1"}))
    moved = {"time": 0.6, "kind": "set_model_state", "caller": "cheat", "model": "robot1"}
    (tmp_path / "interventions.jsonl").write_text(json.dumps(moved) + "\n", encoding="utf-8")
    feed.poll()
    events = feed.news(Place(), 0.0)["events"]
    assert [each["text"] for each in events] == [
        "robot1 touched Wall_1",
        "cheat called set_model_state for robot1 at 0.600 s",
    ]


def test_a_simulation_that_begins_anew_is_told_from_its_beginning(feed, tmp_path):
    place = Place()
    write_record(tmp_path / "record.csv", rows(2.0))
    feed.poll()
    feed.news(place, 0.0)
    (tmp_path / "record.csv").rename(tmp_path / "old.csv")
    feed.poll()
    write_record(tmp_path / "record.csv", rows(0.5))
    feed.poll()
    told = feed.news(place, 0.0)
    assert told["begins"]
    assert told["cars"]["robot1"][-1][0] == 0.475


def test_what_an_earlier_run_has_left_is_not_told(tmp_path):
    write_record(tmp_path / "record.csv", rows(2.0))
    os.utime(tmp_path / "record.csv", (1.0, 1.0))
    late = Feed(tmp_path / "record.csv", tmp_path / "none")
    late.poll()
    assert late.news(Place(), 0.0) is None
