"""core_rtf_map: the core alone on a track's map."""

from ..benchmark import benchmark
from ..core_speed import real_time_factor
from ..spielberg import spielberg


@benchmark("core_rtf_map", "sim s / s", at_least=400)
def core_rtf_map():
    """One car on Spielberg; 1080 beams over 4.7 rad and 30 m, with noise, at 40 Hz; physics at 1 kHz."""
    return real_time_factor(spielberg(1), 60.0)
