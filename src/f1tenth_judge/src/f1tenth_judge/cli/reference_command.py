"""f1tenth reference."""

from pathlib import Path
from typing import Optional

from f1tenth_judge.atomic import replacing
from f1tenth_judge.cli.exit_codes import PASSED
from f1tenth_judge.errors import ScenarioError, writing
from f1tenth_judge.places import lookup
from f1tenth_judge.results.reference_laps import reference_laps_text


def reference(options) -> int:
    """Print the fastest laps, and write them and their lines where that is wanted."""
    # Imported late: scipy takes longer than all else that most commands do.
    from f1tenth_judge.reference.car_limits import CLEARANCE, read_limits
    from f1tenth_judge.reference.fastest_lap import compute_fastest_lap, write_raceline
    from f1tenth_judge.reference.track import load_track

    _expect_folder("--laps", options.laps and options.laps.resolve().parent)
    _expect_folder("--output", options.output)
    limits = read_limits(CLEARANCE if options.clearance is None else options.clearance)
    laps = {}
    for name in options.names or lookup.circuits():
        lap = compute_fastest_lap(load_track(name), limits)
        laps[name] = lap.lap_time
        low, high = lap.speed.min(), lap.speed.max()
        print(f"{name}: {lap.lap_time:.3f} s, {lap.s[-1]:.1f} m, {low:.1f} to {high:.1f} m/s", flush=True)
        if options.output:
            stem = Path(name).stem.removesuffix("_centerline")
            write_raceline(options.output / f"{stem}_raceline.csv", lap, limits)
    if options.laps:
        with writing(options.laps), replacing(options.laps) as temporary:
            temporary.write_text(reference_laps_text(laps), encoding="utf-8")
    return PASSED


def _expect_folder(option: str, folder: Optional[Path]) -> None:
    """Refuse a folder that is not there before the work, not after it."""
    if folder and not folder.is_dir():
        raise ScenarioError(f"{option}: there is no folder {folder}")
