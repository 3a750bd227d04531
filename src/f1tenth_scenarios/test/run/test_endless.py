"""Whether a driver computes without end, by what its threads have had of the processors."""

from f1tenth_judge.drivers.rest import ProcessorUse
from f1tenth_scenarios.run.diagnosis.endless import wanted_by_one


def test_the_thread_counts_that_ran_or_waited_most():
    before = {(1, 1): ProcessorUse(True, 5.0, 1.0, 10), (1, 2): ProcessorUse(False, 3.0, 0.0, 10)}
    after = {
        (1, 1): ProcessorUse(True, 5.5, 2.25, 20),
        (1, 2): ProcessorUse(False, 3.0, 0.25, 12),
        (1, 3): ProcessorUse(True, 9.0, 9.0, 1),
    }
    assert wanted_by_one(before, after) == 1.75
    assert wanted_by_one({}, after) == 0.0
