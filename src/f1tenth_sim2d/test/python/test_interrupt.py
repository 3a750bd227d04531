"""Ctrl-C while the simulation advances."""

import signal

import pytest

END = 20_000.0  # s of simulated time, which take long enough for a signal to come before


def test_advance_to_ends_when_a_signal_raises(simulation):
    def interrupt(_number, _frame):
        raise KeyboardInterrupt

    before = signal.signal(signal.SIGALRM, interrupt)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.05)
        with pytest.raises(KeyboardInterrupt):
            simulation.advance_to(END)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGALRM, before)
    stopped = simulation.time
    assert 0.0 < stopped < END
    simulation.advance_to(stopped + 1.0)
    assert simulation.time == pytest.approx(stopped + 1.0, abs=1e-3)


def test_hash_is_that_of_an_advance_in_steps(simulation, world, car):
    simulation.advance_to(30.0)
    stepped = type(simulation)(world, seed=7)
    stepped.add_car(car)
    while stepped.time < 30.0:
        stepped.step()
    assert simulation.trajectory_hash() == stepped.trajectory_hash()
