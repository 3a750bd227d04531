import pytest
from f1tenth_judge.results.result_file import write_result
from report_samples import result

from f1tenth_judge import cli

RESULT = result(
    "circuit1",
    seed=3,
    settings=["limits.timeout=70"],
    lockstep=True,
    trajectory_hash="a1",
    machine={"architecture": "x86_64", "pinned": True},
)


@pytest.fixture
def verify(tmp_path, monkeypatch):
    """Verify the result that has this content, and let the second run give that one."""

    def run(first, second):
        folder = tmp_path / "first"
        folder.mkdir()
        write_result(folder / "result.json", first)

        def write(plan):
            assert (plan.scenario.seed, plan.scenario.limits.timeout) == (3, 70.0)
            plan.folder.mkdir(parents=True)
            write_result(plan.folder / "result.json", second)
            return 0

        monkeypatch.setattr("f1tenth_judge.cli.verify_command.run_plan", write)
        return cli.main(["verify", str(folder), "--results", str(tmp_path)])

    return run


def test_the_same_trajectory_passes(verify, capsys):
    assert verify(RESULT, RESULT) == 0
    assert "the same trajectory: a1" in capsys.readouterr().out


def test_another_one_fails_and_says_what_differs_between_the_machines(verify, capsys):
    assert verify(RESULT, {**RESULT, "trajectory_hash": "b2", "machine": {"architecture": "x86_64"}}) == 1
    out = capsys.readouterr().out
    assert "another trajectory: b2, not a1\n  pinned: None, not True\n" in out
    assert "architecture" not in out


def test_a_run_that_was_not_in_lockstep_cannot_be_verified(verify, capsys):
    assert verify({**RESULT, "lockstep": False}, RESULT) == 2
    assert "was not in lockstep" in capsys.readouterr().err


def test_an_episode_cannot_be_run_again(verify, capsys):
    assert verify({**RESULT, "machine": None}, RESULT) == 2
    assert "is of an episode, not of a scenario that could be run again" in capsys.readouterr().err


def test_what_is_no_result_is_named(tmp_path, capsys):
    assert cli.main(["verify", str(tmp_path / "none.json")]) == 2
    assert "none.json: not a result that can be read: " in capsys.readouterr().err
