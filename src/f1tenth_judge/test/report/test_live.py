"""A run is watched while it goes on, and knows nothing of that."""

import json
import os
import socket
import threading
import urllib.parse
import urllib.request
from pathlib import Path

import gymnasium
import numpy as np
import pytest
from browser import PATIENCE, chromium
from f1tenth_judge.batch.jobs import Job
from f1tenth_judge.drivers.starting import start_drivers
from f1tenth_judge.plan.race import Race, plan_race, save_race
from f1tenth_judge.record.record import read_record
from f1tenth_judge.record.replay import Drawing
from f1tenth_judge.report.live.feed import Feed, Place
from f1tenth_judge.report.live.runs import Runs, Watcher
from f1tenth_judge.report.live.task import task_of
from f1tenth_judge.report.live.watching import task_of_job, watched
from f1tenth_judge.report.page import write_report
from f1tenth_judge.report.replay_columns import pack_drawing
from f1tenth_judge.results.result_file import write_result
from f1tenth_judge.run.execute import execute
from f1tenth_judge.said.journal import Journal
from f1tenth_judge.scenario.driver import Driver
from f1tenth_judge.stop_request import StopRequest
from f1tenth_sim2d.environments import ENVIRONMENT, register
from report_samples import result
from scenario_samples import rows, write_record

CLASSES = Path(__file__).parents[1] / "drivers" / "python" / "classes.py"


def race(name="watched"):
    return Race("circuit1", 1, [Driver(python=f"{CLASSES}:Follower")], called=name)


def race_plan(folder, name="watched"):
    return plan_race(race(name), folder / name, ["limits.timeout=6"])


def watch(plan):
    return watched([task_of(plan)], plan.name, plan.folder.parent)


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
    with watch(plan) as lead_to:
        address = capsys.readouterr().out.split()[-1]
        watcher = threading.Thread(target=lambda: told.extend(messages(address)))
        watcher.start()
        with connect(address):
            connect(address).close()
            assert drive(plan) == alone
            lead_to("/report.html#watched")
            watcher.join(PATIENCE)
    news = [content for kind, content in told if kind == "news"]
    kinds = [kind for kind, _ in told if kind != "alive"]
    # That it waits is told to who was quick enough.
    assert kinds[: kinds.index("scene")] in (["standing"], ["standing", "standing"])
    assert [each["begins"] for each in news] == [True] + [False] * (len(news) - 1)
    times = [row[0] for each in news for row in each["cars"]["robot1"]]
    track = read_record(plan.record_file).tracks["robot1"]
    assert times == sorted(times)
    assert (times[0], times[-1]) == (pytest.approx(track.time[0]), pytest.approx(track.time[-1], abs=0.05))
    assert told[-1] == ("end", {"page": "/report.html#watched"})


def test_a_page_from_elsewhere_is_refused(tmp_path, capsys):
    with watch(race_plan(tmp_path)):
        address = capsys.readouterr().out.split()[-1]
        request = urllib.request.Request(address, headers={"Host": "elsewhere.example"})
        with pytest.raises(urllib.error.HTTPError, match="403"):
            urllib.request.urlopen(request, timeout=PATIENCE)


def test_the_page_follows_the_run_and_becomes_the_report(tmp_path, capsys):
    plan = race_plan(tmp_path)
    with chromium() as window, watch(plan) as lead_to:
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


def test_what_the_planner_draws_is_on_the_page_at_once(tmp_path, capsys):
    plan = plan_race(
        Race("circuit1", 1, [Driver(python=f"{CLASSES}:Noting")], called="noting"),
        tmp_path / "noting",
        ["limits.timeout=3"],
    )
    with chromium() as window, watch(plan):
        window.get(capsys.readouterr().out.split()[-1])
        until(window, "return document.querySelector('.note').textContent === 'Reading the recording…'")
        drive(plan)
        until(window, "return document.querySelector('.scrub')?.max > 1")
        toggle = window.find_element("css selector", "[data-part=drawings]")
        assert toggle.is_displayed()
        assert toggle.get_attribute("title") == "/robot1/target, /robot1/way"
        assert window.get_log("browser") == []


def test_a_wall_of_runs_shows_each_and_enlarges_one(tmp_path, capsys):
    plans = [race_plan(tmp_path / name, name) for name in ("first", "second")]
    tasks = []
    for plan in plans:
        file = tmp_path / f"{plan.name}.yaml"
        save_race(race(plan.name), file)
        job = Job(str(file), ("limits.timeout=6",), str(plan.folder.parent), name=plan.name)
        tasks.append(task_of_job(job))
    with chromium() as window, watched(tasks, "Two races", tmp_path):
        window.get(capsys.readouterr().out.split()[-1])
        until(window, "return document.querySelectorAll('.tile[data-state=waiting]').length === 2")
        drive(plans[0])
        until(window, "return document.querySelector('.tile[data-state=over] polyline')")
        assert "timeout" in window.find_element("css selector", ".tile[data-state=over]").text
        log = plans[1].folder / "log"
        log.mkdir(parents=True)
        write_record(log / "record.csv", rows(2.0))
        until(window, "return document.querySelector('.tile[data-state=driving] canvas')")
        window.find_element("css selector", ".tile[data-state=driving]").click()
        until(window, "return document.querySelector('.scrub')?.max > 1.5")
        write_result(plans[1].folder / "result.json", result("second"))
        until(window, "return document.querySelector('.reason').textContent === 'Over: success.'")
        assert window.get_log("browser") == []


class FakeServing:
    """In the place of the process that serves."""

    def __init__(self, runs, *_):
        (self.task,) = runs
        FakeServing.last = self

    def close(self):
        pass


@pytest.mark.parametrize("make", [gymnasium.make, gymnasium.make_vec], ids=["one", "vectors"])
def test_episodes_of_an_environment_are_watched_one_after_the_other(monkeypatch, make):
    register()
    monkeypatch.setattr("f1tenth_judge.report.live.episodes.Serving", FakeServing)
    environment = make(ENVIRONMENT, place="circuit1", beams=20, watch=True)
    task, place = FakeServing.last.task, Place()
    feed = Feed(Path(task["record"]), Path(task["interventions"]))
    for _ in range(2):
        environment.reset(seed=1)
        for _ in range(15):
            environment.step(np.zeros_like(environment.action_space.sample()))
        feed.poll()
        told = feed.news(place)
        assert told["begins"]
        (rows_of_car,) = told["cars"].values()
        assert rows_of_car[-1][0] == pytest.approx(15 * 0.025, abs=0.05)
    environment.close()
    assert not Path(task["record"]).exists()


def until(window, script):
    from selenium.webdriver.support.ui import WebDriverWait

    WebDriverWait(window, PATIENCE).until(lambda _: window.execute_script(script))


@pytest.fixture
def feed(tmp_path):
    return Feed(tmp_path / "record.csv", tmp_path / "interventions.jsonl")


def test_a_late_watcher_is_told_all_in_fewer_rows(feed, tmp_path):
    write_record(tmp_path / "record.csv", rows(200.0))
    feed.poll()
    told = feed.news(Place())["cars"]["robot1"]
    assert 500 < len(told) <= 1000
    assert (told[0][0], told[-1][0]) == (0.025, pytest.approx(200.0, abs=0.5))


def test_a_watcher_is_told_everything_once(feed, tmp_path):
    place = Place()
    write_record(tmp_path / "record.csv", rows(1.0))
    feed.poll()
    first = feed.news(place)["cars"]["robot1"]
    assert feed.news(place) is None
    with open(tmp_path / "record.csv", "a", encoding="utf-8") as stream:
        for row in list(rows(2.0))[40:]:
            stream.write(",".join(map(str, row)) + "\n")
    feed.poll()
    second = feed.news(place)
    assert not second["begins"]
    assert len(first) + len(second["cars"]["robot1"]) == 40


def test_contacts_and_interventions_are_events(feed, tmp_path):
    write_record(tmp_path / "record.csv", rows(1.0, contacts={0.5: "Wall_1", 0.525: "Wall_1"}))
    moved = {"time": 0.6, "kind": "set_model_state", "caller": "cheat", "model": "robot1"}
    (tmp_path / "interventions.jsonl").write_text(json.dumps(moved) + "\n", encoding="utf-8")
    feed.poll()
    events = feed.news(Place())["events"]
    assert [each["text"] for each in events] == [
        "robot1 touched Wall_1",
        "cheat called set_model_state for robot1 at 0.600 s",
    ]


def test_a_simulation_that_begins_anew_is_told_from_its_beginning(feed, tmp_path):
    place = Place()
    write_record(tmp_path / "record.csv", rows(2.0))
    feed.poll()
    feed.news(place)
    (tmp_path / "record.csv").rename(tmp_path / "old.csv")
    feed.poll()
    write_record(tmp_path / "record.csv", rows(0.5))
    feed.poll()
    told = feed.news(place)
    assert told["begins"]
    assert told["cars"]["robot1"][-1][0] == 0.475


def test_a_run_of_days_stays_small_and_its_path_whole(feed, tmp_path, monkeypatch):
    monkeypatch.setattr("f1tenth_judge.report.live.feed._KEPT_ROWS", 100)
    place, told = Place(), []
    for end in range(10, 200, 10):
        write_record(tmp_path / "new.csv", rows(float(end)))
        with open(tmp_path / "record.csv", "w", encoding="utf-8") as stream:
            stream.write((tmp_path / "new.csv").read_text(encoding="utf-8"))
        feed.poll()
        told += feed.news(place)["cars"]["robot1"]
    kept = feed.news(Place())["cars"]["robot1"]
    assert len(kept) <= 100
    assert (kept[0][0], kept[-1][0]) == (0.025, told[-1][0])
    assert [row[0] for row in told] == sorted({row[0] for row in told})


def test_the_latest_events_are_kept(feed, tmp_path, monkeypatch):
    monkeypatch.setattr("f1tenth_judge.report.live.feed._KEPT_EVENTS", 2)
    touched = {stamp: f"Wall_{number}" for number, stamp in enumerate((0.1, 0.2, 0.3, 0.4))}
    write_record(tmp_path / "record.csv", rows(0.25, contacts=touched))
    feed.poll()
    place = Place()
    assert [each["time"] for each in feed.news(place)["events"]] == [0.1, 0.2]
    write_record(tmp_path / "record.csv", rows(1.0, contacts=touched))
    feed.poll()
    assert [each["time"] for each in feed.news(place)["events"]] == [0.3, 0.4]


def draw(tmp_path, *times, points=2):
    journal = Journal(tmp_path / "drawings.jsonl")
    for time in times:
        journal.note("/robot1/path", time, [Drawing("#00ff00", [[(time, 0.0)] * points])])
    journal.close()


def test_drawings_are_told_once_and_those_of_one_time_replace_another(feed, tmp_path):
    place = Place()
    write_record(tmp_path / "record.csv", rows(1.0))
    draw(tmp_path, 0.2, 0.4)
    feed.poll()
    told = feed.news(place)["drawn"]
    assert [(each["topic"], each["time"]) for each in told] == [("/robot1/path", 0.2), ("/robot1/path", 0.4)]
    assert told[0]["drawn"] == [pack_drawing(Drawing("#00ff00", [[(0.2, 0.0)] * 2]))]
    assert feed.news(place) is None
    (tmp_path / "drawings.jsonl").open("a", encoding="utf-8").write('{"time":0.6,"topic":"/a","drawn":[]}\n')
    assert feed.poll()
    assert [each["topic"] for each in feed.news(place)["drawn"]] == ["/a"]


def test_the_latest_drawings_are_kept(feed, tmp_path):
    write_record(tmp_path / "record.csv", rows(1.0))
    draw(tmp_path, *range(50), points=5000)
    feed.poll()
    kept = [each["time"] for each in feed.news(Place())["drawn"]]
    assert 1 < len(kept) < 50
    assert kept[-1] == 49


def test_damaged_drawings_are_left_out(feed, tmp_path):
    write_record(tmp_path / "record.csv", rows(1.0))
    draw(tmp_path, 0.2)
    lines = ["{", "[]", '{"time":1,"topic":"/a","drawn":[{"x":1}]}', '{"time":1,"drawn":[]}', "\0"]
    with (tmp_path / "drawings.jsonl").open("a", encoding="utf-8") as stream:
        stream.write("\n".join([*lines, '{"time":2,"topic":"/b","drawn":[]}', ""]))
    feed.poll()
    assert [each["time"] for each in feed.news(Place())["drawn"]] == [0.2, 2]


def test_journal_on_a_full_disk_is_silent(tmp_path, monkeypatch):
    full = os.fdopen(os.open("/dev/full", os.O_WRONLY), "w", buffering=1)
    monkeypatch.setattr(Path, "open", lambda *_, **kinds: full)
    journal = Journal(tmp_path / "drawings.jsonl")
    for time in (0.0, 0.2):
        journal.note("/robot1/path", time, [])
    journal.close()


def test_pipe_in_the_place_of_drawings_is_not_waited_for(feed, tmp_path):
    write_record(tmp_path / "record.csv", rows(1.0))
    os.mkfifo(tmp_path / "drawings.jsonl")
    assert feed.poll()
    assert feed.news(Place())["drawn"] == []
    draw(tmp_path, 0.2)
    feed.poll()
    assert [each["time"] for each in feed.news(Place())["drawn"]] == [0.2]


def test_nothing_remains_of_a_run_without_drawings(tmp_path):
    Journal(tmp_path / "drawings.jsonl").close()
    assert list(tmp_path.iterdir()) == []


@pytest.fixture
def job(tmp_path):
    """A run of a league, and what has been told of it to one watcher."""
    folder = tmp_path / "one"
    (folder / "log").mkdir(parents=True)
    return {"name": "one", "scenario": "one.yaml", "settings": [], "folder": str(folder)}


def test_runs_of_a_league_wait_are_driven_and_end(job, tmp_path):
    runs, watcher = Runs([job, {**job, "name": "two", "folder": str(tmp_path / "two")}]), Watcher()
    states = [(said["run"], said["state"]) for _, said in runs.news(watcher, 0.0)]
    assert states == [("one", "waiting"), ("two", "waiting")]
    write_record(tmp_path / "one" / "log" / "record.csv", rows(1.0))
    runs.poll()
    (kind, standing), (news_kind, news) = runs.news(watcher, 0.0)
    assert (kind, standing["run"], standing["state"]) == ("standing", "one", "driving")
    assert (news_kind, news["run"], news["begins"]) == ("news", "one", True)
    write_result(tmp_path / "one" / "result.json", result("one"))
    runs.poll()
    ((kind, standing),) = runs.news(watcher, 0.0)
    assert (standing["state"], standing["result"]["verdict"]) == ("over", "success")
    assert 1 < len(standing["path"][0]) <= 50
    assert runs.news(watcher, 0.0) == []


def test_a_run_of_an_earlier_league_is_over_until_it_is_driven_again(job, tmp_path):
    write_record(tmp_path / "one" / "log" / "record.csv", rows(1.0))
    write_result(tmp_path / "one" / "result.json", result("one"))
    os.utime(tmp_path / "one" / "log" / "record.csv", (1.0, 1.0))
    runs, watcher = Runs([job]), Watcher()
    assert [said["state"] for _, said in runs.news(watcher, 0.0)] == ["over"]
    write_record(tmp_path / "one" / "log" / "record.csv", rows(1.0))
    runs.poll()
    assert [said["state"] for kind, said in runs.news(watcher, 0.0) if kind == "standing"] == ["driving"]


def test_damaged_record_is_told_as_far_as_it_can_be_read(feed, tmp_path):
    file = tmp_path / "record.csv"
    write_record(file, rows(1.0))
    header, *lines = file.read_bytes().splitlines(keepends=True)
    cut = lines[3].replace(b",", b";")
    wrong = [line.replace(line.split(b",")[2], each) for line, each in zip(lines, (b"x", b"nan", b"\xff\0"))]
    file.write_bytes(header + b"".join([*wrong, cut, b"\0" * 100 + b"\n", *lines[4:]]))
    feed.poll()
    assert len(feed.news(Place())["cars"]["robot1"]) >= 18


def test_record_that_cannot_be_read_is_no_news(tmp_path):
    (tmp_path / "record.csv").mkdir()
    assert not Feed(tmp_path / "record.csv", tmp_path / "none").poll()


def test_car_that_comes_later_is_in_the_scene_from_then_on(tmp_path):
    before = task_of(race_plan(tmp_path))
    runs, watcher = Runs([before]), Watcher()
    Path(before["record"]).parent.mkdir(parents=True)
    write_record(Path(before["record"]), rows(1.0))
    runs.poll()
    runs.news(watcher, 0.0)
    runs.renew({**before, "descriptions": {**before["descriptions"], "robot2": None}})
    _, news = runs.news(watcher, 0.0)[-1]
    assert (news["begins"], len(news["cars"]["robot1"])) == (True, 20)
    assert runs.scene("watched")["columns"] != Runs([before]).scene("watched")["columns"]


def test_what_an_earlier_run_has_left_is_not_told(tmp_path):
    write_record(tmp_path / "record.csv", rows(2.0))
    os.utime(tmp_path / "record.csv", (1.0, 1.0))
    late = Feed(tmp_path / "record.csv", tmp_path / "none")
    late.poll()
    assert late.news(Place()) is None
