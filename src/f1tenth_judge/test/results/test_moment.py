"""The address of the moment in which a run went wrong."""

import dataclasses

from f1tenth_judge.results.moment import moment_of, replay_of
from f1tenth_judge.run.outcome import judged
from scenario_samples import record, rows, sample_plan, scenario, seen


def result_of(folder, **others):
    plan = sample_plan(folder, scenario(), folder / "results" / "a run")
    return judged(plan, seen(record(folder, rows(4.0, **others))), None, {})


def test_it_is_a_second_before_the_first_contact():
    assert moment_of([2.0, 3.0], 4.0) == 1.0
    assert moment_of([0.5], 4.0) == 0.0


def test_without_contact_it_is_a_second_before_the_end():
    assert moment_of([], 4.0) == 3.0


def test_it_is_an_address_that_a_browser_opens(tmp_path):
    hit = result_of(tmp_path, contacts={2.0: "Wall_1"})
    result = dataclasses.replace(hit, name="a run", folder=tmp_path / "a run")
    assert replay_of(result) == f"{(tmp_path / 'report.html').as_uri()}#a%20run?t=1.000"
