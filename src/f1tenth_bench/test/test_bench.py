import json
import sys

import pytest
from f1tenth_bench.__main__ import parse_arguments, result_of
from f1tenth_bench.benchmark import Benchmark, Measured, NotAvailable
from f1tenth_bench.keys import all_benchmarks
from f1tenth_judge.errors import ScenarioError

from f1tenth_bench import benchmark, report

SPEED = Benchmark("speed", "x", lambda: Measured(1.0), at_least=2.0)
TIME = Benchmark("time", "ms", lambda: Measured(1.0), at_most=2.0)


@pytest.mark.parametrize(
    ("which", "value", "ok"),
    [(SPEED, 2.0, True), (SPEED, 1.9, False), (TIME, 2.0, True), (TIME, 2.1, False)],
)
def test_bound_decides(which, value, ok):
    result = report.Result(which, Measured(value))
    assert result.ok is ok
    assert result.verdict == ("yes" if ok else "NO")


def test_figure_with_a_problem_does_not_count():
    result = report.Result(SPEED, Measured(9.0, problem="3 messages were lost"))
    assert result.ok is False
    assert result.verdict == "NO: 3 messages were lost"


def test_what_was_not_measured_is_neither_good_nor_bad():
    result = report.Result(SPEED, None, reason="no data")
    assert result.ok is None
    assert " ".join(report.row(result).split()) == "speed - x >= 2 >= 2 not measured: no data"


@pytest.mark.parametrize("kind", [NotAvailable, ScenarioError])
def test_what_is_missing_costs_only_the_key_that_needs_it(kind):
    def measure():
        raise kind("no data")

    which, calibration = Benchmark("speed", "x", measure, at_least=2.0), object()
    assert result_of(which, calibration) == (report.Result(which, None, reason="no data"), calibration)


def test_keys_that_were_not_measured_stay_in_the_file(tmp_path):
    file = tmp_path / "results" / "bench.json"
    report.write_json([report.Result(SPEED, Measured(1.0)), report.Result(TIME, Measured(1.0))], file)
    report.write_json([report.Result(SPEED, Measured(3.0, {"seconds": 5}), slowness=2.0)], file)
    entries = json.loads(file.read_text())
    assert [entries[key]["measured"] for key in ("speed", "time")] == [3.0, 1.0]
    assert entries["speed"] == {
        "measured": 3.0,
        "unit": "x",
        "limit": 1.0,
        "bound": "at least",
        "reference_limit": 2.0,
        "slowness": 2.0,
        "ok": True,
        "remark": "",
        "details": {"seconds": 5},
    }


def test_a_key_has_one_limit_and_one_function(monkeypatch):
    monkeypatch.setattr(benchmark, "registered", {})
    with pytest.raises(ValueError, match="^speed: a benchmark has either at_least or at_most$"):
        benchmark.benchmark("speed", "x", at_least=1.0, at_most=2.0)
    benchmark.benchmark("speed", "x", at_least=1.0)(SPEED.measure)
    with pytest.raises(ValueError, match="^speed: there are two benchmarks of this name$"):
        benchmark.benchmark("speed", "x", at_least=1.0)(SPEED.measure)


def test_unknown_key_is_refused_with_those_that_there_are(monkeypatch, capsys):
    monkeypatch.setattr(sys, "argv", ["f1tenth_bench", "haste"])
    with pytest.raises(SystemExit) as ended:
        parse_arguments({"speed": SPEED, "time": TIME})
    assert ended.value.code == 2
    assert capsys.readouterr().err.endswith("error: no key haste; allowed are speed, time\n")


def test_every_module_of_keys_is_found():
    assert {"core_rtf", "scan_us_map", "ros_cpu_real_time", "plan_ms", "scenario_cost_s"} <= set(
        all_benchmarks()
    )
