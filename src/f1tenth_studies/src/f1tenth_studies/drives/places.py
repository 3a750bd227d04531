"""Where drives take place: circuits, others' tracks in both directions, random roads."""

from collections.abc import Iterator
from pathlib import Path

from f1tenth_scenarios import places
from f1tenth_studies.drives.drive import Drive
from f1tenth_studies.made_places import road_world, seeds, track_names, track_worlds


def circuit_drives(values: str) -> Iterator[Drive]:
    """Drives on each circuit, with seeds as `scenario sweep --vary` reads them."""
    for name in places.circuits():
        world = places.world_file(name, Path())
        for seed in _seeds("circuits", values):
            yield Drive(name, world, name, seed)


def track_drives(values: str, folder: Path) -> Iterator[Drive]:
    """Drives on the tracks in $F1TENTH_DATA, in both directions; files are written to a folder."""
    for name in track_names() if values else ():
        for world in track_worlds(name, folder):
            for seed in _seeds("tracks", values):
                yield Drive(world.stem.removesuffix("_map"), world, str(world), seed)


def road_drives(values: str, folder: Path) -> Iterator[Drive]:
    """A drive on each road of `make_road`, with the seed of the road; files are written to a folder."""
    for seed in _seeds("roads", values):
        world = road_world(seed, folder)
        yield Drive(f"road {seed}", world, str(world.with_name(f"{world.stem}_centerline.csv")), seed)


def _seeds(key: str, values: str) -> list[int]:
    return seeds(key, values) if values else []
