"""The environments that are stepped together are what each would be alone."""

import os
import signal

import gymnasium
import numpy as np
import pytest
from f1tenth_sim2d.environments import ENVIRONMENT
from gymnasium.vector import AutoresetMode

SETTINGS = {
    "place": "circuit1",
    "start": "random",
    "vehicle": {"mu": (0.8, 1.1)},
    "lidar_noise": (0.0, 0.02),
    "beams": 30,
    "max_time": 2.0,
}
COUNT = 4
STEPS = 150


def make_vec(**settings):
    return gymnasium.make_vec(ENVIRONMENT, COUNT, "vector_entry_point", **{**SETTINGS, **settings})


def actions():
    return np.random.default_rng(0).uniform(-1.0, 0.3, (STEPS, COUNT, 2)).astype(np.float32)


def driven_alone(seed, index):
    """Answers of a single environment that begins anew in the step after it has ended."""
    environment = gymnasium.make(ENVIRONMENT, **SETTINGS).unwrapped
    observation, _ = environment.reset(seed=seed + index)
    answers, ended = [(observation, 0.0, False, False)], False
    for action in actions()[:, index]:
        answer = (environment.reset()[0], 0.0, False, False) if ended else environment.step(action)[:4]
        ended = answer[2] or answer[3]
        answers.append(answer)
    return answers


@pytest.mark.parametrize("threads", [1, 2, 4])
def test_each_is_the_single_one_bit_for_bit(threads):
    environments = make_vec(threads=threads)
    assert environments.metadata["autoreset_mode"] is AutoresetMode.NEXT_STEP
    observation, _ = environments.reset(seed=11)
    answers = [(observation, np.zeros(COUNT), np.zeros(COUNT, bool), np.zeros(COUNT, bool))]
    answers += [environments.step(action)[:4] for action in actions()]
    assert sum((answer[2] | answer[3]).sum() for answer in answers) >= 2 * COUNT
    for index in range(COUNT):
        for alone, (rows, *numbers) in zip(driven_alone(11, index), answers):
            assert all(np.array_equal(alone[0][part], rows[part][index]) for part in rows)
            assert alone[1:] == tuple(each[index] for each in numbers)


def test_what_was_answered_stays_as_it_was():
    environments = make_vec()
    before, _ = environments.reset(seed=1)
    kept = before["scan"].copy()
    for action in actions()[:5]:
        environments.step(action)
    assert np.array_equal(before["scan"], kept)


def test_some_can_be_reset_alone():
    environments = make_vec(observation=("pose",))
    environments.reset(seed=1)
    moved, *_ = environments.step(actions()[0])
    mask = np.array([False, True, False, False])
    observation, _ = environments.reset(seed=[None, 9, None, None], options={"reset_mask": mask})
    assert np.array_equal(observation["pose"][~mask], moved["pose"][~mask])
    assert not np.array_equal(observation["pose"][mask], moved["pose"][mask])


def test_each_needs_a_first_reset():
    environments = make_vec(observation=("pose",))
    mask = np.array([True, False, True, False])
    environments.reset(seed=1, options={"reset_mask": mask})
    with pytest.raises(ValueError, match="^step before the first reset of environments 1, 3, which is not"):
        environments.step(actions()[0])
    environments.reset(seed=1, options={"reset_mask": ~mask})
    assert (environments.step(actions()[0])[4]["time"] == 0.025).all()


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"threads": 0}, "threads: found 0, allowed is a whole number from 1 to 100000"),
        ({"render_mode": "human"}, "render_mode: found 'human', allowed is None"),
    ],
)
def test_bad_settings_are_refused(settings, message):
    with pytest.raises(ValueError, match=message):
        make_vec(**settings)


def test_zero_environments_are_refused():
    with pytest.raises(ValueError, match="num_envs: found 0, allowed is a whole number"):
        gymnasium.make_vec(ENVIRONMENT, 0, "vector_entry_point", **SETTINGS)


def test_bad_actions_move_nothing():
    environments = make_vec(observation=("pose",), lidar_noise=0.0)
    with pytest.raises(ValueError, match="step before the first reset"):
        environments.step(actions()[0])
    environments.reset(seed=1)
    with pytest.raises(ValueError, match=r"actions: found shape \(2, 2\), allowed is \(4, 2\)"):
        environments.step(actions()[0][:2])
    with pytest.raises(ValueError, match="found a number that is not finite"):
        environments.step(np.full((COUNT, 2), np.nan))
    assert (environments.step(actions()[0])[4]["time"] == 0.025).all()


def test_a_closed_one_is_refused():
    environments = make_vec()
    environments.close()
    with pytest.raises(ValueError, match="the environment is closed"):
        environments.reset()


def test_a_forked_process_is_told_that_it_has_no_threads():
    environment = make_vec(threads=2)
    environment.reset(seed=0)
    environment.step(actions()[0])
    child = os.fork()
    if child == 0:
        signal.alarm(30)  # what hangs is killed
        try:
            environment.step(actions()[1])
        except RuntimeError as error:
            environment.close()
            os._exit(0 if "made before a fork" in str(error) else 1)
        os._exit(2)
    assert os.waitpid(child, 0)[1] == 0
    environment.step(actions()[1])
