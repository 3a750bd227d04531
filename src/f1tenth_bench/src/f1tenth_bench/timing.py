"""How time is taken."""

import time
import timeit


def processor_seconds(work, repeats=1):
    """Processor time of this process for a call of work, s: the least of several.

    What else a busy machine does does not count, and whatever disturbs a measurement makes it longer.
    """
    return min(timeit.repeat(work, number=1, repeat=repeats, timer=time.process_time))
